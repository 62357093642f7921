#include "core/sculpt/remesh/edge_split.h"

#include "core/geometry/point_triangle.h"

#include <algorithm>
#include <deque>

namespace core
{
namespace
{
/// Faces per parallel chunk; a dab of the usual size runs on one core.
constexpr std::size_t facesPerChunk = 1024;
} // namespace

/// Returns false if the face certainly has no edge longer than d_detail. A fast test in single precision; its margin is
/// larger than the rounding error.
bool EdgeSplit::mayBeTooLong(Slot f) const
{
    const Triangle& t = m_mesh.corners(f);
    const Vec3f a = m_mesh.point(t[0]), b = m_mesh.point(t[1]), c = m_mesh.point(t[2]);
    constexpr float margin = 1 - 1e-6f;
    return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}) >
           margin * static_cast<float>(m_pass.detail2());
}

/// Returns the longest edge of the face, if it is longer than d_detail and the face meets the ball.
std::optional<RemeshEdge> EdgeSplit::tooLongIn(Slot f, const Sphere& ball) const
{
    if (!mayBeTooLong(f))
        return std::nullopt;
    const Triangle& t = m_mesh.corners(f);
    const std::array<Vec3, 3> p = {m_pass.point(t[0]), m_pass.point(t[1]), m_pass.point(t[2])};
    std::size_t longest = 0;
    double longest2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double l2 = (p[(i + 1) % 3] - p[i]).squaredNorm();
        if (l2 > longest2) {
            longest2 = l2;
            longest = i;
        }
    }
    if (!m_pass.isTooLong(longest2) ||
        (nearestInTriangle(ball.center, p) - ball.center).squaredNorm() > ball.radius * ball.radius)
        return std::nullopt;
    Slot h = m_mesh.faceHalfedge(f);
    while (m_mesh.from(h) != t[longest])
        h = m_mesh.next(h);
    return m_pass.edgeAt(h / 2);
}

std::vector<RemeshEdge> EdgeSplit::tooLongIn(std::span<const Slot> faces, const Sphere& ball) const
{
    const auto collect = [&](std::size_t begin, std::size_t end, std::vector<RemeshEdge>& edges) {
        for (Slot f : faces.subspan(begin, end - begin)) {
            if (const std::optional<RemeshEdge> e = m_pass.edit().names(f) ? tooLongIn(f, ball) : std::nullopt)
                edges.push_back(*e);
        }
    };
    return joinChunks<std::vector<RemeshEdge>>(faces.size(), facesPerChunk, collect);
}

void EdgeSplit::refine(std::span<const Slot> candidates, const Sphere& ball)
{
    std::vector<Slot> faces(candidates.begin(), candidates.end());
    if (m_pass.edit().mirror())
        splitFacesAcross(faces, ball);
    while (!faces.empty()) {
        std::vector<RemeshEdge> edges = tooLongIn(faces, ball);
        SlotSet& seen = m_pass.region().scratch();
        seen.clear();
        std::erase_if(edges, [&](const RemeshEdge& e) { return !seen.add(e.edge); });
        std::ranges::sort(edges, isLonger);
        faces.clear();
        for (const RemeshEdge& e : edges) {
            if (!m_pass.mayGoOn())
                return;
            const Slot m = split(e);
            if (m == noSlot)
                continue;
            select(m, ball);
            m_mesh.forEachOutgoing(m, [&](Slot h) { faces.push_back(m_mesh.face(h)); });
        }
        std::ranges::sort(faces);
        faces.erase(std::ranges::unique(faces).begin(), faces.end());
    }
}

void EdgeSplit::splitFacesAcross(std::vector<Slot>& faces, const Sphere& ball)
{
    const MirrorMap& mirror = *m_pass.edit().mirror();
    // the list grows during the loop: a new face may have another edge across the plane
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Slot first = m_mesh.faceHalfedge(faces[i]);
        for (Slot h : {first, m_mesh.next(first), m_mesh.prev(first)}) {
            const Slot m = mirror.isAcross(h / 2) ? split(m_pass.edgeAt(h / 2)) : noSlot;
            if (m == noSlot)
                continue;
            select(m, ball);
            m_mesh.forEachOutgoing(m, [&](Slot g) { faces.push_back(m_mesh.face(g)); });
            break;
        }
    }
}

/// Adds a new vertex to the region if it is in the ball. (A ray brush repeats its selection after refining.)
void EdgeSplit::select(Slot m, const Sphere& ball)
{
    const double distance2 = (m_pass.point(m) - ball.center).squaredNorm();
    if (distance2 <= ball.radius * ball.radius)
        m_pass.region().add(m, std::sqrt(distance2), Vec3::Zero(), imageDistance(m, ball));
}

/// Returns what Region::carried() is for a new vertex with a mirror: the distance of its image from the ball's centre;
/// twice the radius if no neighbour has a selected image. Returns 0 without a mirror.
double EdgeSplit::imageDistance(Slot m, const Sphere& ball)
{
    const MirrorMap* mirror = m_pass.edit().mirror();
    if (!mirror)
        return 0;
    const Region& region = m_pass.region();
    bool isSelected = false;
    m_mesh.forEachOutgoing(m, [&](Slot h) {
        const Slot other = m_mesh.to(h);
        isSelected = isSelected || (region.contains(other) && region.carried(other) <= ball.radius);
    });
    return isSelected ? (mirror->imageOf(m_pass.point(m)) - ball.center).norm() : 2 * ball.radius;
}

/// Splits the edge unless both ends are masked. Returns the new vertex, or noSlot if the split was refused or rolled
/// back.
Slot EdgeSplit::split(const RemeshEdge& e)
{
    const Slot m = m_mesh.mayBeSplit(e.edge) ? m_pass.edit().split(e.edge) : noSlot;
    if (m == noSlot)
        return noSlot;
    ++m_pass.counts.splits;
    m_pass.noteNew(m);
    m_pass.changed().add(m);
    m_mesh.forEachOutgoing(m, [&](Slot h) { m_pass.changed().add(m_mesh.to(h)); });
    return m;
}

std::vector<RemeshEdge> EdgeSplit::splitLongEdges()
{
    Region& region = m_pass.region();
    std::vector<RemeshEdge> edges =
        m_pass.edges([&](double l2, Slot e) { return m_pass.isTooLong(l2) || m_pass.isTooShort(e, l2); });
    const auto tooShort =
        std::ranges::partition(edges, [&](const RemeshEdge& e) { return m_pass.isTooLong(e.length2); });
    std::vector<RemeshEdge> shortEdges(tooShort.begin(), tooShort.end());
    std::deque<RemeshEdge> queue(edges.begin(), tooShort.begin());
    std::ranges::sort(queue, isLonger);
    SlotSet& created = region.scratch();
    created.clear();
    while (!queue.empty()) {
        const RemeshEdge e = queue.front();
        queue.pop_front();
        if (!m_pass.mayGoOn())
            break;
        const Slot m = split(e);
        if (m == noSlot)
            continue;
        created.add(m);
        region.addBetween(m, e.v0, e.v1);
        m_mesh.forEachOutgoing(m, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            if (region.contains(other) && m_pass.isTooLong(m_pass.length2(h / 2)))
                queue.push_back(m_pass.edgeAt(h / 2));
        });
    }
    m_pass.addShortEdges(created, shortEdges);
    return shortEdges;
}
} // namespace core
