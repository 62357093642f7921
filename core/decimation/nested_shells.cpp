#include "core/decimation/nested_shells.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr std::size_t fewestFaces = 4;
/// Smallest scale of shrink(), and the number of scales tried; each failed try is followed by a milder one.
constexpr double minScale = 0.25;
constexpr int shrinkings = 4;
} // namespace

std::vector<NestedShells::Shell> NestedShells::shells() const
{
    std::vector<Shell> result;
    std::vector<bool> isSeen(m_mesh.slots().vertices, false);
    for (const Slot first : m_mesh.vertices()) {
        if (isSeen[first])
            continue;
        Shell shell;
        shell.vertices.push_back(first);
        isSeen[first] = true;
        for (std::size_t i = 0; i < shell.vertices.size(); ++i) {
            shell.box.extend(m_mesh.point(shell.vertices[i]).cast<double>());
            m_mesh.forEachOutgoing(shell.vertices[i], [&](Slot h) {
                if (const Slot v = m_mesh.to(h); !isSeen[v]) {
                    isSeen[v] = true;
                    shell.vertices.push_back(v);
                }
            });
        }
        result.push_back(std::move(shell));
    }
    std::ranges::stable_sort(result, {}, [](const Shell& shell) { return shell.box.diagonal().squaredNorm(); });
    return result;
}

void NestedShells::run()
{
    std::vector<Shell> all = shells();
    if (all.size() < 2)
        return;
    const auto isNested = [&](const Shell& shell) {
        return std::ranges::any_of(all, [&](const Shell& other) {
            return &other != &shell && (other.box.contains(shell.box) || shell.box.contains(other.box));
        });
    };
    gatherQuadrics();
    const double share = static_cast<double>(m_target) / static_cast<double>(m_mesh.live().faces);
    for (std::size_t i = 0; i < all.size() && m_mesh.live().faces > m_target && !m_control.isCancelled(); ++i) {
        if (!isNested(all[i]))
            continue;
        const auto faces = static_cast<std::size_t>(share * static_cast<double>(all[i].faces()));
        reduce(all[i], std::max(fewestFaces, faces));
        const auto holds = [&](const Shell& other) { return &other != &all[i] && other.box.contains(all[i].box); };
        if (std::any_of(all.begin() + static_cast<std::ptrdiff_t>(i), all.end(), holds))
            shrink(all[i]);
    }
}

void NestedShells::gatherQuadrics()
{
    m_quadrics.assign(m_mesh.slots().vertices, {});
    m_stamps.assign(m_mesh.slots().vertices, 0);
    const auto at = [&](Slot v) { return Vec3(m_mesh.point(v).cast<double>()); };
    for (const Slot f : m_mesh.faces()) {
        const Triangle& t = m_mesh.corners(f);
        const auto quadric = Quadric<3>::ofTriangle(at(t[0]), at(t[1]), at(t[2]));
        for (const Slot v : t)
            m_quadrics[v] += quadric;
    }
}

void NestedShells::push(Slot from, Slot to)
{
    const Vec3 place = m_mesh.point(to).cast<double>();
    m_queue.push({(m_quadrics[from] + m_quadrics[to]).at(place), from, to, m_stamps[from] + m_stamps[to]});
}

void NestedShells::push(Slot v)
{
    m_mesh.forEachOutgoing(v, [&](Slot h) { push(v, m_mesh.to(h)); });
}

/// Collapses vertices into neighbours, in the order of how little that changes the shape, down to about `faces` faces.
void NestedShells::reduce(Shell& shell, std::size_t faces)
{
    std::size_t count = shell.vertices.size();
    m_queue = {};
    for (const Slot v : shell.vertices)
        push(v);
    while (!m_queue.empty() && 2 * count > faces + 4 && m_mesh.live().faces > m_target && !m_control.isCancelled()) {
        const Candidate candidate = m_queue.top();
        m_queue.pop();
        const auto [error, from, to, stamp] = candidate;
        if (!m_mesh.isVertex(from) || !m_mesh.isVertex(to) || stamp != m_stamps[from] + m_stamps[to])
            continue;
        const Slot h = m_mesh.findHalfedge(from, to);
        if (h == noSlot || !m_mesh.isCollapseOk(h))
            continue;
        const Vec3f place = m_mesh.point(to);
        if (!m_surface.tryOperation([&] { m_mesh.collapse(h, place); }))
            continue;
        --count;
        m_quadrics[to] += m_quadrics[from];
        ++m_stamps[to];
        push(to);
        m_mesh.forEachOutgoing(to, [&](Slot out) { push(m_mesh.to(out), to); });
    }
    std::erase_if(shell.vertices, [&](Slot v) { return !m_mesh.isVertex(v); });
}

/// Scales the component down about the mean of its vertices, so far that faces as large as its own fit around it.
/// Tries milder scales if that is not sound.
void NestedShells::shrink(const Shell& shell)
{
    Vec3 middle = Vec3::Zero();
    double longest = 0;
    for (const Slot v : shell.vertices) {
        middle += m_mesh.point(v).cast<double>() / static_cast<double>(shell.vertices.size());
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            longest = std::max(longest, (m_mesh.point(m_mesh.to(h)) - m_mesh.point(v)).cast<double>().norm());
        });
    }
    // a face with edges of length e on a ball of diameter d is nearer to the centre by the factor sqrt(1 - (e / d)^2)
    const double ratio = longest / shell.box.sizes().maxCoeff();
    double scale = std::max(minScale, 1 - 1.1 * ratio * ratio);
    for (int i = 0; i < shrinkings; ++i, scale = std::sqrt(scale)) {
        const auto shrinkAll = [&] {
            for (const Slot v : shell.vertices) {
                const Vec3 p = middle + scale * (m_mesh.point(v).cast<double>() - middle);
                m_mesh.setPoint(v, m_mesh.lattice().snap(p));
            }
        };
        if (m_surface.tryOperation(shrinkAll))
            return;
    }
}
} // namespace core
