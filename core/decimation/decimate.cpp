// Edge collapses one by one, in the order of how little they change the shape:
//   1. quadrics   per vertex, from the planes of its faces, in space or in space and colour together    quadric
//   2. queue      of edges, by the error at the best place for their common vertex
//   3. collapse   of the first edge, unless it flips a face or makes one a sliver
//   4. verify     the changed faces exactly; a collapse that makes faces intersect is rolled back      verified_mesh
//   5. repeat     until there are few enough triangles or no edge can collapse; then again with looser limits and more
//                 places per edge, and at last with any collapse that stays sound
//   6. shells     closely nested components are reduced one by one                                    nested_shells
//   7. search     for the rest: move vertices and flip edges at random until an edge can collapse     coarse_search
// Source: Garland and Heckbert 1997 and 1998 (quadric.h). MeshLab, Blender, meshoptimizer and OpenMesh's decimater do 1
// to 3; none of them does 4. Measured on a wavy ball, 82 thousand to 8 thousand triangles, mean distance: 0.348 mm
// here, 0.363 mm meshoptimizer 0.18 (fifty times faster, 7 pairs of faces intersect), 0.369 mm OpenMesh 9 (6 pairs
// intersect).

#include "core/decimation/decimate.h"
#include "core/decimation/blocked_edges.h"
#include "core/decimation/coarse_search.h"
#include "core/decimation/nested_shells.h"

#include "core/analysis/nesting.h"
#include "core/geometry/quadric.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/normals.h"
#include "core/parts/part_split.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <algorithm>
#include <queue>

namespace core
{
namespace
{
/// Weight of colour in quadrics: the full range of a channel counts as much as this fraction of the model's longest
/// side. A guess that kept painted edges on the models tried.
constexpr double colorReach = 0.1;
/// Small weights that choose between collapses with nearly equal errors, as on flat surfaces. pull: draws the new
/// vertex to the edge's middle. perLength: penalty on the edge's squared length.
constexpr double pull = 1e-6, perLength = 1e-4;
/// Limits of a collapse.
struct Tolerance
{
    double minTurnCosine; ///< smallest cosine between a face's normals before and after
    double minShape;      ///< smallest shape quality of a face, 1: equilateral; a face below it may not get worse
    bool triesAll;        ///< also tries the ends and the middle if the best place fails
};
/// Limits of the three rounds: faces turn by at most about 75 degrees; then no face flips over; then any sound
/// collapse.
constexpr std::array<Tolerance, 3> tolerances = {{{0.25, 0.02, false}, {0.02, 0.002, true}, {-2, 0, true}}};
constexpr std::size_t checkInterval = 1024;
/// A pass over all edges is repeated with the same tolerance if it removed at least one vertex per this number of
/// faces.
constexpr std::size_t minPerPass = 100;
/// If a pass refuses more collapses than this fraction of the mesh's edges, nested components are assumed to obstruct
/// each other.
constexpr double maxRefused = 0.25;

template <int N> class Decimater
{
public:
    Decimater(Mesh& mesh, std::size_t triangles, const JobControl& control)
        : m_mesh(mesh)
        , m_surface(mesh)
        , m_target(triangles)
        , m_control(control)
        , m_stamps(mesh.slots().vertices, 0)
        , m_start(mesh.live().faces)
        , m_blocked(mesh, m_stamps)
    {
        Box box;
        for (const Slot v : mesh.vertices())
            box.extend(mesh.point(v).template cast<double>());
        m_perColor = colorReach * box.sizes().maxCoeff() / 255;
    }

    Decimated run();

private:
    using Point = typename Quadric<N>::Point;
    struct Candidate
    {
        float error;
        Slot v0, v1;
        std::uint32_t stamp0, stamp1;

        // inverted, so that the priority queue's top has the smallest error
        bool operator<(const Candidate& other) const
        {
            return std::tie(other.error, other.v0, other.v1) < std::tie(error, v0, v1);
        }
    };
    struct Place
    {
        Vec3f point;
        Rgb color;
        double error;
    };

    void gatherQuadrics();
    Point pointOf(Slot v) const;
    Place placeFor(Slot v0, Slot v1) const;
    Place placeAt(const Point& p, const Quadric<N>& sum, Slot v1) const;
    void push(Slot v0, Slot v1);
    std::size_t collapseQueue();
    bool collapse(const Candidate& candidate);
    bool collapseAnywhere(Slot h);
    bool collapseTo(Slot h, const Place& place);
    bool keepsFaces(Slot v, Slot other, const Vec3& p) const;
    bool isDone() const { return m_mesh.live().faces <= m_target || m_control.isCancelled(); }
    void tell() const;

    Mesh& m_mesh;
    VerifiedMesh m_surface;
    std::size_t m_target;
    const JobControl& m_control;
    double m_perColor = 0; ///< mm per step of a colour channel
    std::vector<Quadric<N>> m_quadrics;
    std::vector<std::uint32_t> m_stamps; ///< number of changes so far, by vertex
    std::priority_queue<Candidate> m_queue;
    std::size_t m_start;
    std::uint64_t m_refused = 0;
    BlockedEdges m_blocked;
    Tolerance m_tolerance = tolerances[0];
};

template <int N> Decimated Decimater<N>::run()
{
    gatherQuadrics();
    for (const Tolerance& tolerance : tolerances) {
        m_tolerance = tolerance;
        m_blocked.clear();
        std::uint64_t refused = 0;
        for (bool pays = true; pays && !isDone();) {
            refused = m_refused;
            for (const Slot e : m_mesh.edges()) // all edges again: obstacles to a collapse may be gone
                push(m_mesh.from(2 * e), m_mesh.to(2 * e));
            pays = collapseQueue() > m_mesh.live().faces / minPerPass;
            refused = m_refused - refused;
        }
        if (!isDone() && static_cast<double>(refused) > maxRefused * m_mesh.live().edges) {
            NestedShells(m_surface, m_target, m_control).run();
            gatherQuadrics(); // again, because the components have shrunk
        }
    }
    if (!isDone())
        CoarseSearch(m_surface, std::max(m_target, fewestTriangles(extractMesh(m_mesh))), m_control).run();
    if (m_control.isCancelled())
        return {};
    return {extractMesh(m_mesh), m_refused};
}

template <int N> typename Decimater<N>::Point Decimater<N>::pointOf(Slot v) const
{
    Point p;
    p.template head<3>() = m_mesh.point(v).template cast<double>();
    if constexpr (N == 6) {
        const Rgb c = m_mesh.color(v);
        p.template tail<3>() = m_perColor * Vec3(c.r, c.g, c.b);
    }
    return p;
}

template <int N> void Decimater<N>::gatherQuadrics()
{
    m_quadrics.assign(m_mesh.slots().vertices, {});
    for (const Slot f : m_mesh.faces()) {
        const Triangle& t = m_mesh.corners(f);
        const auto quadric = Quadric<N>::ofTriangle(pointOf(t[0]), pointOf(t[1]), pointOf(t[2]));
        for (const Slot v : t)
            m_quadrics[v] += quadric;
    }
}

template <int N> typename Decimater<N>::Place Decimater<N>::placeFor(Slot v0, Slot v1) const
{
    const Quadric<N> sum = m_quadrics[v0] + m_quadrics[v1];
    const Point p0 = pointOf(v0), p1 = pointOf(v1), middle = (p0 + p1) / 2;
    Point best = sum.minimizer(middle, pull);
    const double length2 = (p1 - p0).squaredNorm();
    if (!((best - middle).squaredNorm() < length2)) // nearly flat in some direction, where the minimiser is unreliable
        best = sum.at(p0) < sum.at(p1) ? p0 : p1;
    Place place = placeAt(best, sum, v1);
    place.error += perLength * sum.weight() * length2;
    return place;
}

template <int N>
typename Decimater<N>::Place Decimater<N>::placeAt(const Point& p, const Quadric<N>& sum, Slot v1) const
{
    Place place;
    place.point = m_mesh.lattice().snap(Vec3(p.template head<3>()));
    place.color = m_mesh.color(v1);
    if constexpr (N == 6) {
        const auto part = [&](int i) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(p[i] / m_perColor, 0.0, 255.0)));
        };
        place.color = {part(3), part(4), part(5)};
    }
    place.error = sum.at(p);
    return place;
}

template <int N> void Decimater<N>::push(Slot v0, Slot v1)
{
    m_queue.push({static_cast<float>(placeFor(v0, v1).error), v0, v1, m_stamps[v0], m_stamps[v1]});
}

template <int N> std::size_t Decimater<N>::collapseQueue()
{
    std::size_t collapses = 0;
    for (std::size_t steps = 0;
         !m_queue.empty() && !(steps % checkInterval == 0 ? isDone() : m_mesh.live().faces <= m_target); ++steps) {
        const Candidate candidate = m_queue.top();
        m_queue.pop();
        if (candidate.stamp0 != m_stamps[candidate.v0] || candidate.stamp1 != m_stamps[candidate.v1] ||
            !collapse(candidate))
            continue;
        ++collapses;
        m_mesh.forEachOutgoing(candidate.v1, [&](Slot h) { push(candidate.v1, m_mesh.to(h)); });
        if (steps % checkInterval == 0)
            tell();
    }
    return collapses;
}

template <int N> bool Decimater<N>::collapse(const Candidate& candidate)
{
    const Slot v0 = candidate.v0, v1 = candidate.v1;
    const Slot h = m_mesh.findHalfedge(v0, v1);
    if (h == noSlot)
        return false;
    if (!m_mesh.isCollapseOk(h))
        return false;
    if (m_blocked.isBlocked(v0, v1)) {
        ++m_refused;
        return false;
    }
    m_blocked.begin();
    if (collapseTo(h, placeFor(v0, v1)) || (m_tolerance.triesAll && collapseAnywhere(h)))
        return true;
    m_blocked.keep(v0, v1);
    return false;
}

/// Collapses to one of the ends or to the middle, tried in the order of their error.
template <int N> bool Decimater<N>::collapseAnywhere(Slot h)
{
    const Slot v0 = m_mesh.from(h), v1 = m_mesh.to(h);
    const Quadric<N> sum = m_quadrics[v0] + m_quadrics[v1];
    const Point p0 = pointOf(v0), p1 = pointOf(v1);
    std::array<Place, 3> places = {placeAt(p0, sum, v1), placeAt(p1, sum, v1), placeAt((p0 + p1) / 2, sum, v1)};
    std::ranges::stable_sort(places, {}, &Place::error);
    return std::ranges::any_of(places, [&](const Place& place) { return collapseTo(h, place); });
}

template <int N> bool Decimater<N>::collapseTo(Slot h, const Place& place)
{
    const Slot v0 = m_mesh.from(h), v1 = m_mesh.to(h);
    const Vec3 p = place.point.template cast<double>();
    if (!m_mesh.lattice().contains(p) || !keepsFaces(v0, v1, p) || !keepsFaces(v1, v0, p))
        return false;
    const bool isSound = m_surface.tryOperation([&] {
        m_mesh.collapse(h, place.point);
        if (m_mesh.color(v1) != place.color)
            m_mesh.setColor(v1, place.color);
    });
    if (!isSound) {
        ++m_refused;
        m_blocked.note(m_surface.badFaces(), v0, v1);
        return false;
    }
    m_quadrics[v1] += m_quadrics[v0];
    ++m_stamps[v0];
    ++m_stamps[v1];
    return true;
}

/// Returns true if moving v to p neither flips the faces around v nor makes them slivers. Faces that also touch `other`
/// are ignored, because the collapse removes them.
template <int N> bool Decimater<N>::keepsFaces(Slot v, Slot other, const Vec3& p) const
{
    bool keeps = true;
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const Slot a = m_mesh.to(h), b = m_mesh.to(m_mesh.next(h));
        if (!keeps || a == other || b == other)
            return;
        const Vec3 pa = m_mesh.point(a).template cast<double>(), pb = m_mesh.point(b).template cast<double>();
        const Vec3 before = faceNormal(m_mesh, m_mesh.face(h)), after = (pa - p).cross(pb - p);
        const auto shape = [&](const Vec3& corner, const Vec3& normal) {
            const double edges2 = (pa - corner).squaredNorm() + (pb - corner).squaredNorm() + (pb - pa).squaredNorm();
            return 2 * std::sqrt(3.0) * normal.norm() / edges2;
        };
        const double min = std::min(m_tolerance.minShape, shape(m_mesh.point(v).template cast<double>(), before));
        keeps = after.dot(before) > m_tolerance.minTurnCosine * after.norm() * before.norm() && shape(p, after) >= min;
    });
    return keeps;
}

template <int N> void Decimater<N>::tell() const
{
    const double gone = static_cast<double>(m_start - m_mesh.live().faces);
    m_control.reportProgress(gone /
                             static_cast<double>(std::max<std::size_t>(1, m_start - std::min(m_start, m_target))));
}

bool isColored(const Mesh& mesh)
{
    return std::ranges::any_of(mesh.vertices(), [&](Slot v) { return mesh.color(v) != Rgb(); });
}
} // namespace

std::size_t fewestTriangles(const TriangleMesh& mesh)
{
    const Components shells = componentsOf(mesh.points.size(), mesh.triangles);
    std::vector<std::size_t> faces(shells.count, 0), vertices(shells.count, 0);
    std::vector<bool> isCounted(mesh.points.size(), false);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        ++faces[shells.ofFace[f]];
        for (const Slot v : mesh.triangles[f])
            if (!isCounted[v]) {
                isCounted[v] = true;
                ++vertices[shells.ofFace[f]];
            }
    }
    std::size_t fewest = 0;
    for (std::size_t i = 0; i < shells.count; ++i) {
        // Euler: V - E + F = 2 - 2g with E = 3F/2. With a handle V >= (7 + sqrt(1 + 48g)) / 2, and F = 2 (V + 2g - 2).
        const double genus = (2 - static_cast<double>(vertices[i]) + static_cast<double>(faces[i]) / 2) / 2;
        const double least = genus > 0 ? std::ceil((7 + std::sqrt(1 + 48 * genus)) / 2) : 4;
        fewest += static_cast<std::size_t>(2 * (least + 2 * genus - 2));
    }
    return fewest;
}

Decimated decimate(Mesh mesh, std::size_t triangles, const JobControl& control)
{
    mesh.beginStroke();
    return isColored(mesh) ? Decimater<6>(mesh, triangles, control).run()
                           : Decimater<3>(mesh, triangles, control).run();
}

TriangleMesh decimateEachPart(const TriangleMesh& mesh, const Lattice& lattice, std::size_t triangles,
                              const JobControl& control)
{
    std::vector<PartPiece> pieces = splitByPart(mesh);
    double done = 0;
    for (PartPiece& piece : pieces) {
        const double share =
            static_cast<double>(piece.mesh.triangles.size()) / static_cast<double>(mesh.triangles.size());
        const auto most = static_cast<std::size_t>(share * static_cast<double>(triangles));
        const JobControl part = control.part(done, std::min(done + share, 1.0));
        done += share;
        piece.mesh = decimate(Mesh(piece.mesh, lattice), most, part).mesh;
        if (control.isCancelled())
            break;
    }
    return joined(pieces);
}
} // namespace core
