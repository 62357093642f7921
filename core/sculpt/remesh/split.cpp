// Steps 0 and 1 of remesh.cpp: what is too long is split.

#include "core/sculpt/remesh/remesher.h"

#include "core/geometry/point_triangle.h"

#include <algorithm>
#include <deque>

namespace core
{
namespace
{
bool longestFirst(const RemeshEdge& a, const RemeshEdge& b)
{
    return std::tie(b.length2, a.v0, a.v1) < std::tie(a.length2, b.v0, b.v1);
}
} // namespace

// --- 0. refine

/// Mostly no. Rounds less than its margin.
bool Remesher::mayBeTooLong(Slot f) const
{
    const Triangle& t = m_mesh.corners(f);
    const Vec3f a = m_mesh.point(t[0]), b = m_mesh.point(t[1]), c = m_mesh.point(t[2]);
    constexpr float margin = 1 - 1e-6f;
    return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}) >
           margin * static_cast<float>(m_detail2);
}

/// The longest edge of a face that meets the ball, if it is longer than d_detail.
std::optional<RemeshEdge> Remesher::tooLongIn(Slot f, const Sphere& ball) const
{
    if (!mayBeTooLong(f))
        return std::nullopt;
    const Triangle& t = m_mesh.corners(f);
    const std::array<Vec3, 3> p = {point(t[0]), point(t[1]), point(t[2])};
    std::size_t longest = 0;
    double longest2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double l2 = (p[(i + 1) % 3] - p[i]).squaredNorm();
        if (l2 > longest2) {
            longest2 = l2;
            longest = i;
        }
    }
    if (longest2 <= m_detail2 ||
        (nearestInTriangle(ball.center, p) - ball.center).squaredNorm() > ball.radius * ball.radius)
        return std::nullopt;
    Slot h = m_mesh.faceHalfedge(f);
    while (m_mesh.from(h) != t[longest])
        h = m_mesh.next(h);
    return edgeAt(h / 2);
}

std::vector<RemeshEdge> Remesher::tooLongIn(std::span<const Slot> faces, const Sphere& ball) const
{
    const auto collect = [&](std::size_t begin, std::size_t end, std::vector<RemeshEdge>& edges) {
        for (Slot f : faces.subspan(begin, end - begin)) {
            if (const std::optional<RemeshEdge> e = m_edit.names(f) ? tooLongIn(f, ball) : std::nullopt)
                edges.push_back(*e);
        }
    };
    return joinChunks<std::vector<RemeshEdge>>(faces.size(), facesPerChunk, collect);
}

void Remesher::refine(std::span<const Slot> candidates, const Sphere& ball)
{
    std::vector<Slot> faces(candidates.begin(), candidates.end());
    if (m_edit.mirror())
        partFacesAcross(faces, ball);
    while (!faces.empty()) {
        std::vector<RemeshEdge> edges = tooLongIn(faces, ball);
        SlotSet& seen = m_region.scratch();
        seen.clear();
        std::erase_if(edges, [&](const RemeshEdge& e) { return !seen.add(e.edge); });
        std::ranges::sort(edges, longestFirst);
        faces.clear();
        for (const RemeshEdge& e : edges) {
            if (!mayGoOn())
                return;
            const Slot m = split(e);
            if (m == noSlot)
                continue;
            joinRefined(m, ball);
            m_mesh.forEachOutgoing(m, [&](Slot h) { faces.push_back(m_mesh.face(h)); });
        }
        std::ranges::sort(faces);
        faces.erase(std::ranges::unique(faces).begin(), faces.end());
    }
}

/// Splits the edges across the mirror's plane in their middle. The faces made by that are added.
void Remesher::partFacesAcross(std::vector<Slot>& faces, const Sphere& ball)
{
    const MirrorMap& mirror = *m_edit.mirror();
    for (std::size_t i = 0; i < faces.size(); ++i) { // grows meanwhile: a new face may have another such edge
        const Slot first = m_mesh.faceHalfedge(faces[i]);
        for (Slot h : {first, m_mesh.next(first), m_mesh.prev(first)}) {
            const Slot m = mirror.isAcross(h / 2) ? split(edgeAt(h / 2)) : noSlot;
            if (m == noSlot)
                continue;
            joinRefined(m, ball);
            m_mesh.forEachOutgoing(m, [&](Slot g) { faces.push_back(m_mesh.face(g)); });
            break;
        }
    }
}

/// A vertex of refine() within the ball joins the region. (The ray brush selects anew when the mesh is fine enough.)
void Remesher::joinRefined(Slot m, const Sphere& ball)
{
    const double distance2 = (point(m) - ball.center).squaredNorm();
    if (distance2 <= ball.radius * ball.radius)
        m_region.add(m, std::sqrt(distance2));
}

/// The new vertex, or noSlot if the split was taken back.
Slot Remesher::split(const RemeshEdge& e)
{
    const Slot m = m_mesh.mayBeSplit(e.edge) ? m_edit.split(e.edge) : noSlot;
    if (m == noSlot)
        return noSlot;
    ++counts.splits;
    m_changed.add(m);
    m_mesh.forEachOutgoing(m, [&](Slot h) { m_changed.add(m_mesh.to(h)); });
    return m;
}

// --- 1. split

/// Returns the short edges: no split touches one, and among the new edges there are more.
std::vector<RemeshEdge> Remesher::splitLongEdges()
{
    std::vector<RemeshEdge> edges = regionEdges([&](double l2, Slot) { return l2 > m_detail2 || l2 < m_minimum2; });
    const auto tooShort = std::ranges::partition(edges, [&](const RemeshEdge& e) { return e.length2 > m_detail2; });
    std::vector<RemeshEdge> shortEdges(tooShort.begin(), tooShort.end());
    std::deque<RemeshEdge> queue(edges.begin(), tooShort.begin());
    std::ranges::sort(queue, longestFirst);
    SlotSet& created = m_region.scratch();
    created.clear();
    while (!queue.empty()) {
        const RemeshEdge e = queue.front();
        queue.pop_front();
        if (!mayGoOn())
            break;
        const Slot m = split(e);
        if (m == noSlot)
            continue;
        created.add(m);
        m_region.addBetween(m, e.v0, e.v1);
        m_mesh.forEachOutgoing(m, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            if (m_region.contains(other) && length2(h / 2) > m_detail2)
                queue.push_back(edgeAt(h / 2));
        });
    }
    addShortEdges(created, shortEdges);
    return shortEdges;
}
} // namespace core
