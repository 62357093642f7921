// The whole model to one d_detail, with what a dab does under its brush (paper, section 3.2):
//   1. patches   the vertices along a Morton curve, cut into pieces of like size, each with the ring around it
//   2. optimise  each patch that has an edge out of bounds, letting collapses make some edges too long   remesh
//   3. even out  its vertices: towards their neighbours' mean, and back onto the surface as it was (Botsch and Kobbelt 2004)
//   4. split     what is too long then
//   5. judge     each patch exactly; what fails is done again, operation by operation                judged_mesh
//   6. repeat    with pieces cut elsewhere, until the mesh is even or gets no more even
//   7. judge     the whole, exactly                                                                  lattice_fit

#include "uniform_remesh.h"

#include "deform.h"
#include "judged_mesh.h"
#include "lattice_fit.h"
#include "model_transform.h"
#include "morton_order.h"
#include "remesh.h"
#include "surface_query.h"

#include <algorithm>

namespace core
{
namespace
{
/// Of a patch when it is done, about; and when it begins.
constexpr double verticesPerPatch = 1024;
constexpr std::size_t leastPerPatch = 8;
constexpr int mostRounds = 48;
/// A round that leaves more than this share of the short edges of the round before has made no progress.
constexpr double leastProgress = 0.98;
/// A vertex returns to the surface as it was from this far at most, in d_detail, and only to faces that look its way.
constexpr double farthestFromSurface = 0.5, sameSheetCosine = 0.5;
/// A collapse may make an edge this much longer than d_detail; its halves, when it is split, are longer than d.
constexpr double slack = 1.3;
/// Vertices at edges sharper than about 45 degrees stay where they are.
constexpr double creaseCosine = 0.7;
/// Of equilateral triangles, the edges of a uniform mesh are this long, in d_detail (measured).
constexpr double typicalEdge = 0.7;
/// Shares of the time: each round takes this much of what is left; judging the whole takes the rest.
constexpr double shareOfRound = 0.4, afterRounds = 0.9;

Vec3 faceNormal(const Mesh& mesh, Slot f)
{
    const Triangle& t = mesh.corners(f);
    const Vec3 a = mesh.point(t[0]).cast<double>();
    return (mesh.point(t[1]).cast<double>() - a).cross(mesh.point(t[2]).cast<double>() - a);
}

/// The surface as it was, for points that lie near it.
class OriginalSurface
{
public:
    explicit OriginalSurface(const Mesh& mesh) : m_mesh(mesh), m_octree(mesh), m_boxes(mesh.slots().faces)
    {
        for (Slot f = 0; f < m_boxes.size(); ++f) {
            if (m_mesh.isFace(f))
                m_boxes[f] = boxOf(m_mesh, f);
        }
    }

    struct Place
    {
        Vec3 point;
        Slot face;
    };
    /// The nearest within the reach; of several the one on the lowest face.
    std::optional<Place> near(const Vec3& p, double reach) const;
    Vec3 normal(Slot face) const { return faceNormal(m_mesh, face); }

private:
    Mesh m_mesh;
    FaceOctree m_octree;
    std::vector<LatticeBox> m_boxes; ///< by face
};

std::optional<OriginalSurface::Place> OriginalSurface::near(const Vec3& p, double reach) const
{
    const LatticeBox box = latticeBox(m_mesh.lattice(), {p, reach});
    std::optional<Place> best;
    double best2 = reach * reach;
    m_octree.query(box, [&](Slot f) {
        if (!m_boxes[f].meets(box))
            return;
        const Triangle& t = m_mesh.corners(f);
        const auto corner = [&](int i) { return Vec3(m_mesh.point(t[i]).cast<double>()); };
        const Vec3 point = nearestInTriangle(p, {corner(0), corner(1), corner(2)});
        const double distance2 = (point - p).squaredNorm();
        if (distance2 < best2 || (distance2 == best2 && best && f < best->face)) {
            best2 = distance2;
            best = {point, f};
        }
    });
    return best;
}

class UniformRemesher
{
public:
    UniformRemesher(Mesh& mesh, const EdgeBounds& bounds, const JobWatch& watch)
        : m_mesh(mesh), m_bounds(bounds), m_watch(watch), m_surface(mesh), m_original(mesh)
    {
    }

    void run();

private:
    std::vector<Slot> alongCurve() const;
    void round(int number);
    std::size_t patchSize() const;
    void fillRegion(std::span<const Slot> vertices);
    bool isOutOfBounds() const;
    void optimisePatch();
    void optimiseWith(MeshEditor edit);
    Vec3 evenPlace(Slot v) const;
    bool isAtCrease(Slot v) const;

    Mesh& m_mesh;
    EdgeBounds m_bounds;
    const JobWatch& m_watch;
    JudgedMesh m_surface;
    OriginalSurface m_original;
    Region m_region;
    bool m_onlySplits = false; ///< all but a few long edges is done
    double m_done = 0;
};

void UniformRemesher::run()
{
    Evenness before = evennessOf(m_mesh, m_bounds);
    for (int number = 0; number < mostRounds && !before.isUniform() && !m_watch.stopped(); ++number) {
        m_onlySplits = number > 0 && !before.hasManyShort();
        round(number);
        const Evenness after = evennessOf(m_mesh, m_bounds);
        const bool progress = number == 0 || before.tooLong > 0 ||
                              static_cast<double>(after.tooShort) < leastProgress * static_cast<double>(before.tooShort);
        if (after.tooLong == 0 && !progress)
            return;
        before = after;
    }
}

/// By where they are now: new vertices have any slot.
std::vector<Slot> UniformRemesher::alongCurve() const
{
    std::vector<std::pair<std::uint64_t, Slot>> keys;
    keys.reserve(m_mesh.live().vertices);
    for (Slot v = 0; v < m_mesh.slots().vertices; ++v) {
        if (m_mesh.isVertex(v))
            keys.emplace_back(mortonCodeOf(m_mesh.latticePoint(v)), v);
    }
    std::ranges::sort(keys);
    std::vector<Slot> order;
    order.reserve(keys.size());
    for (const auto& [code, v] : keys)
        order.push_back(v);
    return order;
}

/// Smaller where the mesh is to become much finer: a patch is judged, and can be stopped, as a whole.
std::size_t UniformRemesher::patchSize() const
{
    const double growth = std::max(1.0, uniformFaces(areaOf(m_mesh), m_bounds.detail) / m_mesh.live().faces);
    return std::max(leastPerPatch, static_cast<std::size_t>(verticesPerPatch / growth));
}

void UniformRemesher::round(int number)
{
    const std::vector<Slot> order = alongCurve();
    const double share = shareOfRound * (afterRounds - m_done);
    const std::size_t perPatch = patchSize();
    const std::size_t shift = number % 2 == 0 ? 0 : perPatch / 2;
    for (std::size_t end = perPatch - shift, begin = 0; begin < order.size(); begin = end, end += perPatch) {
        if (m_watch.stopped())
            return;
        end = std::min(end, order.size());
        fillRegion(std::span(order).subspan(begin, end - begin));
        if (number == 0 || isOutOfBounds())
            optimisePatch();
        m_watch.reached(m_done + share * static_cast<double>(end) / static_cast<double>(order.size()));
    }
    m_done += share;
}

/// Those still alive, and their neighbours: so that each edge lies within some patch.
void UniformRemesher::fillRegion(std::span<const Slot> vertices)
{
    m_region.clear();
    for (const Slot v : vertices) {
        if (!m_mesh.isVertex(v))
            continue;
        m_region.add(v, 0);
        m_mesh.forEachOutgoing(v, [&](Slot h) { m_region.add(m_mesh.to(h), 0); });
    }
}

bool UniformRemesher::isOutOfBounds() const
{
    bool found = false;
    m_region.forEach([&](Slot v) {
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            if (found || other < v || !m_region.contains(other))
                return;
            const double length2 = (m_mesh.point(other) - m_mesh.point(v)).cast<double>().squaredNorm();
            found = length2 > m_bounds.detail * m_bounds.detail || length2 < m_bounds.minimum * m_bounds.minimum;
        });
    });
    return found;
}

void UniformRemesher::optimisePatch()
{
    const Region::Saved saved = m_region.save();
    const Mesh::Mark mark = m_mesh.mark();
    optimiseWith(MeshEditor(m_mesh));
    if (m_surface.judge(mark))
        return;
    m_mesh.rollback(mark);
    m_region.restore(saved);
    optimiseWith(MeshEditor(m_mesh, [&](const auto& operation) { return m_surface.attempt(operation); }));
}

void UniformRemesher::optimiseWith(MeshEditor edit)
{
    const auto evenOut = [&] { moveSoundly(edit, m_region, m_bounds, [&](Slot v) { return evenPlace(v); }); };
    if (!m_onlySplits) {
        const EdgeBounds loose = {slack * m_bounds.detail, m_bounds.minimum};
        optimise(edit, m_region, loose);
        evenOut();
    }
    splitLongEdges(edit, m_region, m_bounds);
    evenOut(); // middles of edges lie inside round shapes
}

/// Relaxed, then on the surface as it was: not on another sheet of it.
Vec3 UniformRemesher::evenPlace(Slot v) const
{
    if (isAtCrease(v))
        return m_mesh.point(v).cast<double>();
    const Vec3 relaxed = relaxedPlace(m_mesh, m_bounds, v);
    const auto original = m_original.near(relaxed, farthestFromSurface * m_bounds.detail);
    if (!original)
        return relaxed;
    const Vec3 normal = vertexNormal(m_mesh, v), other = m_original.normal(original->face);
    const bool isOwnSheet = other.dot(normal) > sameSheetCosine * other.norm() * normal.norm();
    return isOwnSheet ? original->point : relaxed;
}

bool UniformRemesher::isAtCrease(Slot v) const
{
    bool found = false;
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 n0 = faceNormal(m_mesh, m_mesh.face(h)), n1 = faceNormal(m_mesh, m_mesh.face(h ^ 1));
        found = found || n0.dot(n1) < creaseCosine * n0.norm() * n1.norm();
    });
    return found;
}
} // namespace

Evenness evennessOf(const Mesh& mesh, const EdgeBounds& bounds)
{
    Evenness evenness;
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (!mesh.isEdge(e))
            continue;
        const double length2 = (mesh.point(mesh.to(2 * e)) - mesh.point(mesh.to(2 * e + 1))).cast<double>().squaredNorm();
        ++evenness.edges;
        evenness.tooLong += length2 > bounds.detail * bounds.detail ? 1 : 0;
        evenness.tooShort += length2 < bounds.minimum * bounds.minimum ? 1 : 0;
    }
    return evenness;
}

double areaOf(const Mesh& mesh)
{
    double sum = 0;
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        if (mesh.isFace(f))
            sum += faceNormal(mesh, f).norm() / 2;
    }
    return sum;
}

double uniformFaces(double area, double detailLength)
{
    const double edge = typicalEdge * detailLength;
    return area / (std::sqrt(3.0) / 4 * edge * edge);
}

void remeshUniformly(Mesh& mesh, const RemeshUniformly& command, ModelChange& change, const JobWatch& watch)
{
    const EdgeBounds bounds = edgeBounds(command.detailLength > 0 ? command.detailLength : mesh.uniformDetail());
    const double faces = uniformFaces(areaOf(mesh), bounds.detail);
    if (bounds.detail < mesh.lattice().minDetail() || faces > ModelLimits::mostFaces) {
        change.refusal = ModelRefusal::TooFine;
        change.faces = static_cast<std::size_t>(std::min(faces, 1e15));
        return;
    }
    UniformRemesher(mesh, bounds, watch).run();
    if (watch.stopped())
        return;
    const LatticeFit fit = fitToLattice(mesh.lattice(), placesOf(mesh), liveFaces(mesh), watch);
    if (fit.unsnappable > 0 || fit.resnapped > 0) {
        change.refusal = ModelRefusal::FacesMeet;
        change.faces = fit.unsnappable;
    }
    mesh.setUniformDetail(bounds.detail);
}
} // namespace core
