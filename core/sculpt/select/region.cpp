#include "core/sculpt/select/region.h"

#include "core/geometry/point_triangle.h"

#include <algorithm>
#include <queue>

namespace core
{
void Region::clear()
{
    for (Slot v : m_index.slots())
        m_present.remove(v);
    m_index.clear();
    m_distance.clear();
    m_plan.clear();
    m_carried.clear();
    m_live = 0;
}

void Region::add(Slot v, double distance, Vec3 plan, double carried)
{
    const Slot i = m_index.add(v);
    if (i == m_plan.size()) {
        m_distance.emplace_back();
        m_plan.emplace_back();
        m_carried.emplace_back();
    }
    m_distance[i] = distance;
    m_plan[i] = plan;
    m_carried[i] = carried;
    m_live += contains(v) ? 0 : 1;
    m_present.add(v);
}

void Region::addBetween(Slot v, Slot a, Slot b)
{
    add(v, 0.5 * (distance(a) + distance(b)), 0.5 * (plan(a) + plan(b)), 0.5 * (carried(a) + carried(b)));
}

void Region::remove(Slot v)
{
    m_present.remove(v);
    --m_live;
}

Region::Saved Region::save() const
{
    Saved saved = {m_index.slots(), m_distance, m_plan, m_carried, {}};
    std::ranges::copy_if(saved.slots, std::back_inserter(saved.gone), [&](Slot v) { return !contains(v); });
    return saved;
}

void Region::restore(const Saved& saved)
{
    clear();
    for (std::size_t i = 0; i < saved.slots.size(); ++i)
        add(saved.slots[i], saved.distance[i], saved.plan[i], saved.carried[i]);
    for (Slot v : saved.gone)
        remove(v);
}

std::vector<Slot> withNeighbours(Region& region, const Mesh& mesh, std::span<const Slot> vertices)
{
    SlotSet& around = region.scratch();
    around.clear();
    for (Slot v : vertices) {
        if (v >= mesh.slots().vertices || !mesh.isVertex(v))
            continue;
        around.add(v);
        mesh.forEachOutgoing(v, [&](Slot h) { around.add(mesh.to(h)); });
    }
    std::vector<Slot> present;
    std::ranges::copy_if(around.slots(), std::back_inserter(present), [&](Slot v) { return region.contains(v); });
    return present;
}

std::vector<Slot> cornersOf(const Mesh& mesh, std::span<const Slot> faces)
{
    std::vector<Slot> corners;
    for (Slot f : faces)
        corners.insert(corners.end(), mesh.corners(f).begin(), mesh.corners(f).end());
    return corners;
}

void selectSphere(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const FaceOctree& octree,
                  const Sphere& ball)
{
    region.clear();
    candidates = facesIn(mesh, octree, latticeBox(mesh.lattice(), ball));
    SlotSet& corners = region.scratch();
    corners.clear();
    const double radius2 = ball.radius * ball.radius;
    for (Slot f : candidates) {
        for (Slot v : mesh.corners(f))
            corners.add(v);
    }
    corners.sort();
    for (Slot v : corners.slots()) {
        const double distance2 = (mesh.point(v).cast<double>() - ball.center).squaredNorm();
        if (distance2 <= radius2)
            region.add(v, std::sqrt(distance2));
    }
}

namespace
{
/// Returns the candidate triangle nearest to the centre; the one with the lowest slot if several are equally near;
/// noSlot if there are no candidates.
Slot faceUnder(const Vec3& center, const std::vector<Slot>& candidates, const Mesh& mesh)
{
    Slot face = noSlot;
    double nearest2 = 0;
    for (Slot f : candidates) {
        const Triangle& t = mesh.corners(f);
        const auto point = [&](Slot v) -> Vec3 { return mesh.point(v).cast<double>(); };
        const double d2 = (nearestInTriangle(center, {point(t[0]), point(t[1]), point(t[2])}) - center).squaredNorm();
        if (face == noSlot || d2 < nearest2 || (d2 == nearest2 && f < face)) {
            face = f;
            nearest2 = d2;
        }
    }
    return face;
}
} // namespace

void selectGeodesic(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const Sphere& ball, Slot max)
{
    const Slot face = faceUnder(ball.center, candidates, mesh);
    using Reached = std::pair<double, Slot>; // among equal distances, the lower slot comes first
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    const auto reach = [&](Slot v, double distance) {
        if (distance <= ball.radius) // then v is within the ball, since no path is shorter than the straight line
            front.emplace(distance, v);
    };
    const auto point = [&](Slot v) { return Vec3(mesh.point(v).cast<double>()); };
    for (Slot v : mesh.corners(face))
        reach(v, (point(v) - ball.center).norm());
    SlotSet& done = region.scratch();
    done.clear();
    std::vector<std::pair<Slot, double>> selected;
    while (!front.empty()) {
        const auto [distance, v] = front.top();
        front.pop();
        if (done.contains(v))
            continue;
        if (selected.size() == max) {
            selected.clear();
            break;
        }
        done.add(v);
        selected.emplace_back(v, distance);
        mesh.forEachOutgoing(v, [&](Slot h) {
            if (!done.contains(mesh.to(h)))
                reach(mesh.to(h), distance + (point(mesh.to(h)) - point(v)).norm());
        });
    }
    std::ranges::sort(selected);
    region.clear();
    for (const auto& [v, distance] : selected)
        region.add(v, distance);
    SlotSet& faces = region.scratch();
    faces.clear();
    faces.add(face);
    region.forEach([&](Slot v) { mesh.forEachOutgoing(v, [&](Slot h) { faces.add(mesh.face(h)); }); });
    candidates = faces.slots();
}
} // namespace core
