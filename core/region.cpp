#include "region.h"

namespace core
{
void Region::clear()
{
    m_index.clear();
    m_plan.clear();
    m_present.clear();
    m_live = 0;
}

void Region::add(Slot v, const Vec3& plan)
{
    const Slot i = m_index.add(v);
    if (i == m_plan.size()) {
        m_plan.push_back(plan);
        m_present.push_back(1);
        ++m_live;
        return;
    }
    m_live += m_present[i] ? 0 : 1;
    m_plan[i] = plan;
    m_present[i] = 1;
}

void Region::remove(Slot v)
{
    m_present[m_index.position(v)] = 0;
    --m_live;
}

void Region::restore(const Saved& saved)
{
    m_index.truncate(saved.slots);
    m_plan = saved.plan;
    m_present = saved.present;
    m_live = saved.live;
}

LatticeBox latticeBox(const Lattice& lattice, const Sphere& ball)
{
    constexpr double limit = Lattice::limit;
    const Eigen::Array3d reach = Eigen::Array3d::Constant(ball.radius);
    const Eigen::Array3d low = (ball.center.array() - reach) / lattice.unit();
    const Eigen::Array3d high = (ball.center.array() + reach) / lattice.unit();
    return {low.floor().max(-limit).min(limit).matrix().cast<int>(), high.ceil().max(-limit).min(limit).matrix().cast<int>()};
}

void selectSphere(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const FaceOctree& octree,
                  const Sphere& ball)
{
    region.clear();
    candidates.clear();
    SparseIndex& corners = region.scratch();
    corners.clear();
    const double radius2 = ball.radius * ball.radius;
    octree.query(latticeBox(mesh.lattice(), ball), [&](Slot f) {
        candidates.push_back(f);
        for (Slot v : mesh.corners(f))
            corners.add(v);
    });
    for (Slot v : corners.slots()) {
        if ((mesh.point(v).cast<double>() - ball.center).squaredNorm() <= radius2)
            region.add(v, Vec3::Zero());
    }
    region.sort();
}
} // namespace core
