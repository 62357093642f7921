#include "core/decimation/coarse_search.h"

#include <algorithm>

namespace core
{
namespace
{
/// The search ends after this number of visits in a row, per vertex of the mesh, that removed nothing.
constexpr std::size_t vainVisits = 400;
/// Limit on the faces that all checks together visit, and the fixed cost of one check, counted in faces.
constexpr std::size_t maxFacesVisited = 25'000'000, facesPerCheck = 10;
/// Limits of m_tolerance: the first value, the largest, and the factor by which it grows after `vainVisitsAtTolerance`
/// visits per vertex without a removal.
constexpr double firstTolerance = 0.02, maxTolerance = 1, growth = 1.5;
constexpr std::size_t vainVisitsAtTolerance = 20;
} // namespace

/// Stores the position of each vertex and the size of its connected component.
void CoarseSearch::measure()
{
    m_homes.assign(m_mesh.slots().vertices, Vec3::Zero());
    m_sizes.assign(m_mesh.slots().vertices, 0);
    std::vector<Slot> shell;
    for (const Slot first : m_mesh.vertices()) {
        if (m_sizes[first] > 0)
            continue;
        Box box;
        shell.assign(1, first);
        m_sizes[first] = 1;
        for (std::size_t i = 0; i < shell.size(); ++i) {
            m_homes[shell[i]] = m_mesh.point(shell[i]).cast<double>();
            box.extend(m_homes[shell[i]]);
            m_mesh.forEachOutgoing(shell[i], [&](Slot h) {
                if (const Slot v = m_mesh.to(h); m_sizes[v] == 0) {
                    m_sizes[v] = 1;
                    shell.push_back(v);
                }
            });
        }
        for (const Slot v : shell)
            m_sizes[v] = box.sizes().maxCoeff();
    }
}

void CoarseSearch::run()
{
    measure();
    m_tolerance = firstTolerance;
    std::vector<Slot> order;
    for (std::size_t vain = 0; !isDone();) {
        order.clear();
        for (const Slot v : m_mesh.vertices())
            order.push_back(v);
        if (vain > vainVisits * order.size())
            return;
        if (vain > vainVisitsAtTolerance * order.size() && m_tolerance < maxTolerance) {
            m_tolerance = std::min(maxTolerance, m_tolerance * growth);
            vain = 0;
        }
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[m_random() % i]);
        for (const Slot v : order) {
            if (isDone() || m_facesVisited > maxFacesVisited)
                return;
            if (!m_mesh.isVertex(v))
                continue;
            const std::size_t removed = m_removed;
            visit(v);
            vain = m_removed > removed ? 0 : vain + 1;
        }
    }
}

bool CoarseSearch::attempt(const std::function<void()>& step)
{
    const bool isSound = m_surface.tryOperation(step);
    m_facesVisited += facesPerCheck + m_surface.facesVisited();
    return isSound;
}

void CoarseSearch::visit(Slot v)
{
    if (remove(v))
        return;
    flipAt(v);
    move(v);
}

/// Collapses one of the vertex's edges to its other end. Returns false if no such collapse is sound.
bool CoarseSearch::remove(Slot v)
{
    Slot h = m_mesh.outgoing(v);
    for (unsigned i = 0, valence = m_mesh.valence(v); i < valence; ++i, h = m_mesh.rotate(h)) {
        if (!m_mesh.isCollapseOk(h))
            continue;
        const Vec3f end = m_mesh.point(m_mesh.to(h));
        if (attempt([&] { m_mesh.collapse(h, end); })) {
            ++m_removed;
            return true;
        }
    }
    return false;
}

void CoarseSearch::flipAt(Slot v)
{
    Slot h = m_mesh.outgoing(v);
    for (std::size_t i = m_random() % m_mesh.valence(v); i > 0; --i)
        h = m_mesh.rotate(h);
    if (m_random() % 2 == 0)
        h = m_mesh.next(h);
    const Slot e = h / 2;
    if (!m_mesh.isFlipOk(e))
        return;
    const auto middle = [&](Slot a, Slot b) {
        return Vec3((m_mesh.point(a).cast<double>() + m_mesh.point(b).cast<double>()) / 2);
    };
    const Vec3 before = middle(m_mesh.to(2 * e), m_mesh.to(2 * e + 1)),
               after = middle(m_mesh.to(m_mesh.next(2 * e)), m_mesh.to(m_mesh.next(2 * e + 1)));
    if ((after - before).norm() <= 2 * limitAt(v))
        attempt([&] { m_mesh.flip(e); });
}

void CoarseSearch::move(Slot v)
{
    double reach = limitAt(v);
    for (std::size_t i = m_random() % 4; i > 0; --i)
        reach /= 3;
    const Vec3 to = m_mesh.point(v).cast<double>() + reach * Vec3(random(), random(), random());
    if (m_mesh.lattice().contains(to) && (to - m_homes[v]).norm() <= limitAt(v))
        attempt([&] { m_mesh.setPoint(v, m_mesh.lattice().snap(to)); });
}

/// Returns a random number from -1 to 1.
double CoarseSearch::random()
{
    return static_cast<double>(m_random()) / 2147483648.0 - 1;
}
} // namespace core
