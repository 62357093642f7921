// Quasi-uniform optimisation of a region (paper, section 3.2), in its order:
//   0. refine:   faces under the brush that are too large for it, whether or not their corners are selected
//   1. split:    edges longer than d_detail by a queue, at the midpoint           (3.2.1, Figure 5)
//   2. collapse: edges shorter than d, the shortest first, to the midpoint or an end, until no more may be
//                (3.2.2, Figures 6 and 7)
//   3. flip:     edges whose two opposite angles exceed 180 degrees together      (Delaunay's criterion)
//   4. relax:    vertices around the changes, towards their neighbours' mean, along the surface
// No step after the splits makes an edge longer than d_detail, the last two none shorter than d.
// Keys of each order are total (length, then slots), so that results depend only on the mesh.

#include "remesh.h"

#include "collapse_shape.h"
#include "deform.h"
#include "parallel.h"
#include "surface_query.h"

#include <algorithm>
#include <deque>

namespace core
{
namespace
{
/// Operations per sub-step, by the region's vertices and in all: guards against endless work, not a tuning knob.
constexpr std::uint64_t opsPerVertex = 64, leastOps = 4096, mostOps = 1 << 19;
/// A collapse may turn a face by at most about 78 degrees (cos > 0.2: notes of El Topo's legality tests, Brochu 2009).
constexpr double leastTurnCosine = 0.2;
/// A flip is a change of triangulation, not of shape: only across edges flatter than about 25 degrees.
constexpr double flatCosine = 0.9;
/// The smallest angle that a step may make, unless there was a smaller one before. A collapse: 5 degrees; more would block
/// collapses that mend what surrounds them. Relaxation: 20 degrees, the least that a dab should leave.
constexpr double collapsedAngleSine = 0.0872, relaxedAngleSine = 0.342;
/// Where the shape is kept: a place this near to the planes around it, in d, lies on them; one this near will do if there is
/// none, and so will one whose squared distance is little larger than the least.
constexpr double onPlanes = 0.02, nearPlanes = 0.03, littleLarger = 1.5;
/// There a collapse may narrow an angle below collapsedAngleSine, in squared sines, to this: slivers around the tip of a cone
/// must narrow a hair to become fewer, and would lose the tip else.
constexpr double keptOfSliver2 = 0.5;
constexpr double relaxation = 0.5;
constexpr int flipPasses = 4;
/// What a core takes at a time: a dab of the usual size does not wake the others.
constexpr std::size_t verticesPerChunk = 512, facesPerChunk = 1024;

struct Edge
{
    double length2;
    Slot v0, v1; ///< v0 < v1
    Slot edge;
};

bool longestFirst(const Edge& a, const Edge& b)
{
    return std::tie(b.length2, a.v0, a.v1) < std::tie(a.length2, b.v0, b.v1);
}

class Remesher
{
public:
    Remesher(MeshEditor& edit, Region& region, const EdgeBounds& bounds, bool keepsShape = false)
        : m_edit(edit), m_mesh(edit.mesh()), m_region(region), m_bounds(bounds), m_detail2(bounds.detail * bounds.detail),
          m_minimum2(bounds.minimum * bounds.minimum),
          m_opsLeft(std::min(mostOps, leastOps + opsPerVertex * region.size())), m_changed(region.remeshed()),
          m_keepsShape(keepsShape)
    {
        m_changed.clear();
    }

    void refine(std::span<const Slot> candidates, const Sphere& ball);
    std::vector<Edge> splitLongEdges();
    void collapseShortEdges(std::vector<Edge> edges);
    void flipEdges();
    template <class Place> void relax(Place place);
    void moveTo(const std::function<Vec3(Slot)>& place);

    RemeshCounts counts;

private:
    struct Merged
    {
        Vec3f point;
        Vec3 plan;
    };
    /// What a step may do to a face, unless it was worse before.
    struct Limits
    {
        double angleSine;
        double shortest2;
        double keptSliver2 = 1; ///< of a smaller angle's squared sine, what must be left
    };
    using Choices = std::array<Merged, 3>;
    Limits collapseLimits() const { return {collapsedAngleSine, 0, m_keepsShape ? keptOfSliver2 : 1}; }
    Limits relaxLimits() const { return {relaxedAngleSine, m_minimum2}; }

    Vec3 point(Slot v) const { return m_mesh.point(v).cast<double>(); }
    double length2(Slot e) const { return (point(m_mesh.to(2 * e)) - point(m_mesh.to(2 * e + 1))).squaredNorm(); }
    bool mayGoOn();
    template <class Wanted> std::vector<Edge> regionEdges(Wanted wanted) const;
    Edge edgeAt(Slot e) const;
    void addShortEdges(const SparseIndex& around, std::vector<Edge>& edges) const;
    bool mayBeTooLong(Slot f) const;
    std::optional<Edge> tooLongIn(Slot f, const Sphere& ball) const;
    std::vector<Edge> tooLongIn(std::span<const Slot> faces, const Sphere& ball) const;
    void joinRefined(Slot m, const Sphere& ball);
    void partFacesAcross(std::vector<Slot>& faces, const Sphere& ball);
    Slot split(const Edge& e);
    std::vector<Edge> collapse(std::vector<Edge> edges);
    std::vector<Edge> flip(std::vector<Edge> edges);
    std::optional<Merged> mergedEnds(Slot h) const;
    std::size_t keepShape(Slot h, Choices& choices) const;
    bool staysSound(Slot v, Slot ignored, const Vec3& target, const Limits& limits) const;
    bool shouldFlip(Slot e) const;
    void moveVertex(Slot v, const Vec3& place);

    MeshEditor& m_edit;
    const Mesh& m_mesh;
    Region& m_region;
    EdgeBounds m_bounds;
    double m_detail2, m_minimum2;
    std::uint64_t m_opsLeft;
    SparseIndex& m_changed; ///< vertices around operations
    bool m_keepsShape;
};

/// Twice a triangle's area, and the squared sine of its smallest angle: the one between the two longest sides.
struct Shape
{
    Vec3 normal;
    double area2; ///< the normal's squared length
    double smallestSine2;
};

Shape shapeOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
    const double shortest = std::min({ab, bc, ca});
    const double longest = shortest == ab ? bc * ca : shortest == bc ? ca * ab : ab * bc;
    const double area2 = normal.squaredNorm();
    return {normal, area2, longest > 0 ? area2 / longest : 0};
}

bool Remesher::mayGoOn()
{
    if (m_opsLeft == 0) {
        counts.capped = true;
        return false;
    }
    --m_opsLeft;
    return true;
}

Edge Remesher::edgeAt(Slot e) const
{
    const Slot a = m_mesh.to(2 * e), b = m_mesh.to(2 * e + 1);
    return {length2(e), std::min(a, b), std::max(a, b), e};
}

/// Edges with both ends in the region that are wanted by their squared length and slot. `wanted` runs on all cores.
template <class Wanted> std::vector<Edge> Remesher::regionEdges(Wanted wanted) const
{
    const std::vector<Slot>& slots = m_region.slots();
    return joinChunks<std::vector<Edge>>(slots.size(), verticesPerChunk,
                                         [&](std::size_t begin, std::size_t end, std::vector<Edge>& edges) {
                                             for (std::size_t i = begin; i < end; ++i) {
                                                 const Slot v = slots[i];
                                                 if (!m_region.contains(v))
                                                     continue;
                                                 const Vec3 p = point(v);
                                                 m_mesh.forEachOutgoing(v, [&](Slot h) {
                                                     const Slot other = m_mesh.to(h);
                                                     if (other < v || !m_region.contains(other))
                                                         return;
                                                     const double l2 = (point(other) - p).squaredNorm();
                                                     if (wanted(l2, h / 2))
                                                         edges.push_back({l2, v, other, h / 2});
                                                 });
                                             }
                                         });
}

// --- 0. refine -------------------------------------------------------------------------------------------------------------

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
std::optional<Edge> Remesher::tooLongIn(Slot f, const Sphere& ball) const
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

std::vector<Edge> Remesher::tooLongIn(std::span<const Slot> faces, const Sphere& ball) const
{
    return joinChunks<std::vector<Edge>>(
        faces.size(), facesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<Edge>& edges) {
            for (Slot f : faces.subspan(begin, end - begin)) {
                if (const std::optional<Edge> e = m_edit.names(f) ? tooLongIn(f, ball) : std::nullopt)
                    edges.push_back(*e);
            }
        });
}

void Remesher::refine(std::span<const Slot> candidates, const Sphere& ball)
{
    std::vector<Slot> faces(candidates.begin(), candidates.end());
    if (m_edit.mirror())
        partFacesAcross(faces, ball);
    while (!faces.empty()) {
        std::vector<Edge> edges = tooLongIn(faces, ball);
        std::ranges::sort(edges, longestFirst);
        edges.erase(std::ranges::unique(edges, {}, &Edge::edge).begin(), edges.end());
        faces.clear();
        for (const Edge& e : edges) {
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
Slot Remesher::split(const Edge& e)
{
    const Slot m = m_edit.split(e.edge);
    if (m == noSlot)
        return noSlot;
    ++counts.splits;
    m_changed.add(m);
    m_mesh.forEachOutgoing(m, [&](Slot h) { m_changed.add(m_mesh.to(h)); });
    return m;
}

// --- 1. split --------------------------------------------------------------------------------------------------------------

/// Returns the short edges: no split touches one, and among the new edges there are more.
std::vector<Edge> Remesher::splitLongEdges()
{
    std::vector<Edge> edges = regionEdges([&](double l2, Slot) { return l2 > m_detail2 || l2 < m_minimum2; });
    const auto tooShort = std::ranges::partition(edges, [&](const Edge& e) { return e.length2 > m_detail2; });
    std::vector<Edge> shortEdges(tooShort.begin(), tooShort.end());
    std::deque<Edge> queue(edges.begin(), tooShort.begin());
    std::ranges::sort(queue, longestFirst);
    SparseIndex& created = m_region.scratch();
    created.clear();
    while (!queue.empty()) {
        const Edge e = queue.front();
        queue.pop_front();
        if (!mayGoOn())
            break;
        const Slot m = split(e);
        if (m == noSlot)
            continue;
        created.add(m);
        m_region.add(m, 0.5 * (m_region.distance(e.v0) + m_region.distance(e.v1)),
                     0.5 * (m_region.plan(e.v0) + m_region.plan(e.v1)));
        m_mesh.forEachOutgoing(m, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            if (m_region.contains(other) && length2(h / 2) > m_detail2)
                queue.push_back(edgeAt(h / 2));
        });
    }
    addShortEdges(created, shortEdges);
    return shortEdges;
}

// --- 2. collapse -----------------------------------------------------------------------------------------------------------

/// Whether the faces around v, but those with `ignored`, stay sound when v moves to the target.
bool Remesher::staysSound(Slot v, Slot ignored, const Vec3& target, const Limits& limits) const
{
    bool sound = true;
    const Vec3 p = point(v);
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const Slot b = m_mesh.to(h), c = m_mesh.to(m_mesh.next(h));
        if (!sound || b == ignored || c == ignored)
            return;
        const Vec3 pb = point(b), pc = point(c);
        const Shape before = shapeOf(p, pb, pc), after = shapeOf(target, pb, pc);
        const double turn = before.normal.dot(after.normal);
        const double before2 = (p - pb).squaredNorm(), after2 = (target - pb).squaredNorm();
        if (turn <= 0 || turn * turn <= leastTurnCosine * leastTurnCosine * before.area2 * after.area2 ||
            after.smallestSine2 < std::min(limits.angleSine * limits.angleSine, limits.keptSliver2 * before.smallestSine2) ||
            after2 > std::max(m_detail2, before2) || after2 < std::min(limits.shortest2, before2))
            sound = false;
    });
    return sound;
}

/// Where the ends of a short edge may become one: in the middle, or at one of them. No edge grows longer than d_detail.
std::optional<Remesher::Merged> Remesher::mergedEnds(Slot h) const
{
    if (!m_mesh.isCollapseOk(h))
        return std::nullopt;
    const Slot v0 = m_mesh.from(h), v1 = m_mesh.to(h);
    const Vec3 &plan0 = m_region.plan(v0), &plan1 = m_region.plan(v1);
    Choices choices = {
        {{m_edit.middle(h / 2), 0.5 * (plan0 + plan1)}, {m_mesh.point(v1), plan1}, {m_mesh.point(v0), plan0}}};
    const std::size_t count = m_keepsShape ? keepShape(h, choices) : choices.size();
    for (Merged merged : std::span(choices).first(count)) {
        merged.point = m_edit.kept(v1, merged.point);
        const Vec3 p = merged.point.cast<double>();
        if (staysSound(v0, v1, p, collapseLimits()) && staysSound(v1, v0, p, collapseLimits()))
            return merged;
    }
    return std::nullopt;
}

/// Sorts the choices by how well they keep to the planes of the faces around. Returns how many do.
std::size_t Remesher::keepShape(Slot h, Choices& choices) const
{
    if (foldsUp(m_mesh, h))
        return 0;
    const auto error = [&](const Merged& merged) { return planeError(m_mesh, h, merged.point.cast<double>()) / m_minimum2; };
    std::ranges::stable_sort(choices, {}, [&](const Merged& merged) {
        const double e = error(merged);
        return e > onPlanes * onPlanes ? e : 0;
    });
    const double most = littleLarger * error(choices[0]) + nearPlanes * nearPlanes;
    const auto end = std::ranges::find_if(choices, [&](const Merged& merged) { return error(merged) > most; });
    return static_cast<std::size_t>(end - choices.begin());
}

void Remesher::collapseShortEdges(std::vector<Edge> edges)
{
    while (!edges.empty())
        edges = collapse(std::move(edges));
    std::ranges::sort(counts.blocked); // those that were tried again stand there twice
    counts.blocked.erase(std::ranges::unique(counts.blocked).begin(), counts.blocked.end());
}

/// Collapses the edges that it may, the shortest first. Returns the short edges around what it did: they changed, or may be
/// collapsed now.
std::vector<Edge> Remesher::collapse(std::vector<Edge> edges)
{
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        return std::tie(a.length2, a.v0, a.v1) < std::tie(b.length2, b.v0, b.v1);
    });
    SparseIndex& around = m_region.scratch();
    around.clear();
    for (const Edge& e : edges) {
        if (!m_mesh.isEdge(e.edge) || length2(e.edge) >= m_minimum2)
            continue;
        const Slot h = m_edit.collapsing(e.edge), gone = m_mesh.from(h), stays = m_mesh.to(h);
        const std::optional<Merged> merged = mergedEnds(h);
        if (!merged)
            counts.blocked.push_back({gone, stays});
        if (!merged || !mayGoOn() || !m_edit.collapse(h, merged->point))
            continue;
        ++counts.collapses;
        m_region.setPlan(stays, merged->plan);
        m_region.remove(gone);
        around.add(stays);
        m_mesh.forEachOutgoing(stays, [&](Slot g) { around.add(m_mesh.to(g)); });
    }
    for (Slot v : around.slots()) {
        if (m_mesh.isVertex(v))
            m_changed.add(v);
    }
    edges.clear();
    addShortEdges(around, edges);
    return edges;
}

/// Those with an end among the vertices.
void Remesher::addShortEdges(const SparseIndex& around, std::vector<Edge>& edges) const
{
    for (Slot v : around.slots()) {
        if (!m_region.contains(v))
            continue;
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            const bool seen = other < v && around.contains(other);
            if (!seen && m_region.contains(other) && length2(h / 2) < m_minimum2)
                edges.push_back(edgeAt(h / 2));
        });
    }
}

// --- 3. flip ---------------------------------------------------------------------------------------------------------------

/// Delaunay's criterion, cot(alpha) + cot(beta) < 0, on faces that lie nearly in one plane before and after.
bool Remesher::shouldFlip(Slot e) const
{
    const Slot h = 2 * e;
    const Vec3 a = point(m_mesh.from(h)), b = point(m_mesh.to(h));
    const Vec3 c = point(m_mesh.to(m_mesh.next(h))), d = point(m_mesh.to(m_mesh.next(h ^ 1)));
    const double dot0 = (a - c).dot(b - c), dot1 = (a - d).dot(b - d);
    if (dot0 >= 0 && dot1 >= 0)
        return false; // neither angle is obtuse
    const Vec3 n0 = (b - a).cross(c - a), n1 = (d - a).cross(b - a);
    const double area0 = n0.norm(), area1 = n1.norm();
    if (area0 == 0 || area1 == 0)
        return false;
    const double cotangents = dot0 / area0 + dot1 / area1;
    if (cotangents > -1e-3 || n0.dot(n1) < flatCosine * area0 * area1)
        return false;
    const Vec3 m0 = (a - c).cross(d - c), m1 = (d - c).cross(b - c); // the new faces c,a,d and c,d,b
    const double least = flatCosine * area0, length2 = (c - d).squaredNorm();
    return m0.dot(n0) > least * m0.norm() && m1.dot(n0) > least * m1.norm() && length2 >= m_minimum2 &&
           length2 <= m_detail2 && m_mesh.isFlipOk(e);
}

void Remesher::flipEdges()
{
    std::vector<Edge> edges = regionEdges([&](double, Slot e) { return shouldFlip(e); });
    for (int pass = 0; pass < flipPasses && !edges.empty(); ++pass)
        edges = flip(std::move(edges));
}

/// Returns those that should be flipped next: only around a flip can an edge have changed its mind.
std::vector<Edge> Remesher::flip(std::vector<Edge> edges)
{
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) { return std::tie(a.v0, a.v1) < std::tie(b.v0, b.v1); });
    SparseIndex& around = m_region.scratch();
    around.clear();
    for (const Edge& e : edges) {
        if (!shouldFlip(e.edge) || !mayGoOn() || !m_edit.flip(e.edge))
            continue;
        ++counts.flips;
        for (Slot h : {2 * e.edge, 2 * e.edge + 1}) {
            for (Slot v : {m_mesh.to(h), m_mesh.to(m_mesh.next(h))}) {
                m_changed.add(v);
                around.add(v);
            }
        }
    }
    std::vector<Edge> next;
    for (Slot v : around.slots()) {
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            for (Slot e : {h / 2, m_mesh.next(h) / 2}) { // of all faces around v
                if (m_region.contains(m_mesh.to(2 * e)) && m_region.contains(m_mesh.to(2 * e + 1)) && shouldFlip(e))
                    next.push_back(edgeAt(e));
            }
        });
    }
    std::ranges::sort(next, {}, &Edge::edge);
    next.erase(std::ranges::unique(next, {}, &Edge::edge).begin(), next.end());
    return next;
}

// --- 4. relax --------------------------------------------------------------------------------------------------------------

template <class Place> void Remesher::relax(Place place)
{
    m_changed.sort();
    for (Slot v : m_changed.slots()) {
        if (m_mesh.isVertex(v) && m_region.contains(v))
            moveVertex(v, place(v));
    }
}

void Remesher::moveTo(const std::function<Vec3(Slot)>& place)
{
    m_region.forEach([&](Slot v) { moveVertex(v, place(v)); });
}

void Remesher::moveVertex(Slot v, const Vec3& place)
{
    const Lattice& lattice = m_mesh.lattice();
    if (!lattice.contains(place))
        return; // along the surface, but past the wall of the volume
    const Vec3f target = m_edit.kept(v, lattice.snap(place));
    if (staysSound(v, noSlot, target.cast<double>(), relaxLimits()))
        m_edit.move(v, target);
}
} // namespace

Vec3 relaxedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v)
{
    const auto point = [&](Slot u) { return Vec3(mesh.point(u).cast<double>()); };
    Vec3 sum = Vec3::Zero();
    int n = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        sum += point(mesh.to(h));
        ++n;
    });
    const Vec3 p = point(v), normal = vertexNormal(mesh, v);
    Vec3 step = relaxation * (sum / n - p);
    const double squared = normal.squaredNorm();
    if (squared > 0)
        step -= step.dot(normal) / squared * normal;
    const double longest2 = 0.25 * bounds.minimum * bounds.minimum;
    const double step2 = step.squaredNorm();
    return step2 > longest2 ? Vec3(p + std::sqrt(longest2 / step2) * step) : Vec3(p + step);
}

RemeshCounts& RemeshCounts::operator+=(const RemeshCounts& more)
{
    splits += more.splits;
    collapses += more.collapses;
    flips += more.flips;
    capped = capped || more.capped;
    blocked.insert(blocked.end(), more.blocked.begin(), more.blocked.end());
    return *this;
}

RemeshCounts refine(MeshEditor& edit, Region& region, std::span<const Slot> candidates, const Sphere& ball,
                    const EdgeBounds& bounds)
{
    Remesher remesher(edit, region, bounds);
    remesher.refine(candidates, ball);
    return remesher.counts;
}

RemeshCounts optimise(MeshEditor& edit, Region& region, const EdgeBounds& bounds)
{
    Remesher remesher(edit, region, bounds);
    remesher.collapseShortEdges(remesher.splitLongEdges());
    remesher.flipEdges();
    remesher.relax([&](Slot v) { return relaxedPlace(edit.mesh(), bounds, v); });
    return remesher.counts;
}

RemeshCounts optimiseKeepingShape(MeshEditor& edit, Region& region, const EdgeBounds& bounds,
                                  const std::function<Vec3(Slot)>& place)
{
    Remesher remesher(edit, region, bounds, true);
    remesher.collapseShortEdges(remesher.splitLongEdges());
    remesher.flipEdges();
    remesher.relax(place);
    return remesher.counts;
}

void moveSoundly(MeshEditor& edit, Region& region, const EdgeBounds& bounds, const std::function<Vec3(Slot)>& place)
{
    Remesher(edit, region, bounds).moveTo(place);
}

RemeshCounts splitLongEdges(MeshEditor& edit, Region& region, const EdgeBounds& bounds)
{
    Remesher remesher(edit, region, bounds);
    remesher.splitLongEdges();
    return remesher.counts;
}
} // namespace core
