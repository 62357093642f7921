// Finds the shortest cycles at a vertex (Erickson and Whittlesey, Greedy optimal homotopy and homology generators,
// 2005):
//   1. tree       finds the shortest paths from the vertex, up to half the length of a cycle
//   2. cotree     connects faces across the edges outside the tree, first across those that would close the longest
//                 cycles; all faces that were not reached count as one face
//   3. essential  keeps the remaining edges: each closes a cycle that does not bound a disc of reached faces
// The result is the shortest of these cycles that is of the requested kind and does not separate the surface.

#include "core/sculpt/fuse/cycle_search.h"

#include "core/sculpt/fuse/cycle_cut.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace core
{
namespace
{
constexpr std::size_t maxReached = 512;
/// Largest number of cycles to try at a vertex, and of faces to visit on each side of a cycle in isSeparating(). A
/// guard only: the two sides of a tunnel worth filling meet within fewer faces.
constexpr int maxTried = 8;
constexpr std::size_t maxFaces = 8192;

Vec3 pointOf(const Mesh& mesh, Slot v)
{
    return mesh.point(v).cast<double>();
}
} // namespace

std::vector<Slot> CycleSearch::find(const Mesh& mesh, const SlotSet& among, Slot v, Around kind, double maxLength)
{
    if (!reach(mesh, among, v, 0.5 * maxLength))
        return {};
    findClosings(mesh);
    keepEssential(mesh);
    int tried = 0;
    for (const Closing& closing : m_closings) {
        if (closing.length > maxLength || ++tried > maxTried)
            break;
        std::vector<Slot> cycle = cycleOf(mesh, closing.halfedge);
        if (isTunnel(mesh, cycle) == (kind == Around::Tunnel) && !isSeparating(mesh, cycle))
            return cycle;
    }
    return {};
}

/// Finds the shortest paths from the source by Dijkstra's algorithm. Returns false if more than maxReached vertices are
/// within the radius (mm).
bool CycleSearch::reach(const Mesh& mesh, const SlotSet& among, Slot source, double radius)
{
    m_reached.clear();
    m_distance.clear();
    m_parent.clear();
    std::priority_queue<std::pair<double, Slot>, std::vector<std::pair<double, Slot>>, std::greater<>> queue;
    const auto offer = [&](Slot v, double distance, Slot parent) {
        const Slot i = m_reached.add(v);
        if (i == m_distance.size()) {
            m_distance.push_back(distance);
            m_parent.push_back(parent);
        } else if (distance < m_distance[i]) {
            m_distance[i] = distance;
            m_parent[i] = parent;
        } else {
            return;
        }
        queue.emplace(distance, v);
    };
    offer(source, 0, noSlot);
    while (!queue.empty() && m_reached.size() <= maxReached) {
        const auto [distance, v] = queue.top();
        queue.pop();
        if (distance > m_distance[m_reached.position(v)])
            continue;
        mesh.forEachOutgoing(v, [&](Slot h) {
            const double there = distance + (pointOf(mesh, mesh.to(h)) - pointOf(mesh, v)).norm();
            if (there <= radius && among.contains(mesh.to(h)))
                offer(mesh.to(h), there, v);
        });
    }
    return m_reached.size() <= maxReached;
}

void CycleSearch::findClosings(const Mesh& mesh)
{
    m_closings.clear();
    for (Slot v : m_reached.slots()) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot w = mesh.to(h), j = m_reached.find(w);
            if (w < v || j == noSlot)
                return;
            const Slot i = m_reached.position(v);
            if (m_parent[i] != w && m_parent[j] != v)
                m_closings.push_back({m_distance[i] + m_distance[j] + (pointOf(mesh, w) - pointOf(mesh, v)).norm(), h});
        });
    }
    std::ranges::sort(m_closings, [](const Closing& a, const Closing& b) {
        return std::tie(a.length, a.halfedge) > std::tie(b.length, b.halfedge);
    });
}

/// Keeps the edges that a spanning tree of the faces does not cross, and sorts their cycles by ascending length.
void CycleSearch::keepEssential(const Mesh& mesh)
{
    m_faces.clear();
    m_roots.assign(1, 0);
    std::erase_if(m_closings, [&](const Closing& closing) {
        const Slot left = rootOf(nodeOf(mesh, mesh.face(closing.halfedge)));
        const Slot right = rootOf(nodeOf(mesh, mesh.face(closing.halfedge ^ 1)));
        m_roots[std::max(left, right)] = std::min(left, right);
        return left != right;
    });
    std::ranges::reverse(m_closings);
}

Slot CycleSearch::nodeOf(const Mesh& mesh, Slot face)
{
    if (!std::ranges::all_of(mesh.corners(face), [&](Slot v) { return m_reached.contains(v); }))
        return 0;
    const Slot node = m_faces.add(face) + 1;
    if (node == m_roots.size())
        m_roots.push_back(node);
    return node;
}

Slot CycleSearch::rootOf(Slot node)
{
    while (m_roots[node] != node)
        node = m_roots[node] = m_roots[m_roots[node]];
    return node;
}

std::vector<Slot> CycleSearch::cycleOf(const Mesh& mesh, Slot halfedge) const
{
    const auto pathFrom = [&](Slot v) {
        std::vector<Slot> path;
        for (; v != noSlot; v = m_parent[m_reached.position(v)])
            path.push_back(v);
        return path;
    };
    std::vector<Slot> cycle = pathFrom(mesh.from(halfedge)), other = pathFrom(mesh.to(halfedge));
    Slot last = noSlot; // the vertex where the two paths meet
    while (!cycle.empty() && !other.empty() && cycle.back() == other.back()) {
        last = cycle.back();
        cycle.pop_back();
        other.pop_back();
    }
    cycle.push_back(last);
    cycle.insert(cycle.end(), other.rbegin(), other.rend());
    return cycle;
}

/// Returns whether the cycle separates the surface. Grows both sides of the cycle, in turn, until they meet (false) or
/// one side has no more faces (true). Also returns true if neither happens within maxFaces faces.
bool CycleSearch::isSeparating(const Mesh& mesh, const std::vector<Slot>& cycle)
{
    m_edges.clear();
    for (std::size_t i = 0; i < cycle.size(); ++i)
        m_edges.add(mesh.findHalfedge(cycle[i], cycle[(i + 1) % cycle.size()]) / 2);
    const Slot first = mesh.findHalfedge(cycle[0], cycle[1]);
    m_left.clear();
    m_right.clear();
    m_left.add(mesh.face(first));
    m_right.add(mesh.face(first ^ 1));
    bool doMeet = false;
    const auto grow = [&](SlotSet& side, const SlotSet& other, std::size_t i) {
        Slot h = mesh.faceHalfedge(side.slots()[i]);
        for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
            if (m_edges.contains(h / 2))
                continue;
            const Slot face = mesh.face(h ^ 1);
            doMeet = doMeet || other.contains(face);
            side.add(face);
        }
    };
    for (std::size_t i = 0; i < std::min({m_left.size(), m_right.size(), maxFaces}) && !doMeet; ++i) {
        grow(m_left, m_right, i);
        grow(m_right, m_left, i);
    }
    return !doMeet;
}
} // namespace core
