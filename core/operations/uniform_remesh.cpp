// Remeshes the whole model to one d_detail, with the operations that a dab applies under its brush (paper, section
// 3.2):
//   1. patches   cut the vertices along a Morton curve into pieces of similar size, each with its one-ring
//   2. optimise  each patch that has an edge out of bounds; collapses may make some edges too long        remesh
//   3. even out  move its vertices to their neighbours' mean, then back onto the original surface     reference_surface
//   4. split     edges that are too long now
//   5. verify    each patch exactly; a patch that fails is redone, operation by operation             verified_mesh
//   6. repeat    with other patch borders, until the mesh is uniform or improves no more
//   7. raise     the vertices a little, so that round shapes keep their volume                        reference_surface
//   8. check     the whole mesh exactly                                                               lattice_fit

#include "core/operations/uniform_remesh.h"

#include "core/geometry/morton_order.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/normals.h"
#include "core/operations/reference_surface.h"
#include "core/operations/transform.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/verify/mesh_transaction.h"

#include <algorithm>

namespace core
{
namespace
{
/// Approximate number of vertices in a finished patch, and the smallest number that a patch starts with.
constexpr double verticesPerPatch = 1024;
constexpr std::size_t minPerPatch = 8;
constexpr int maxRounds = 48;
/// A round has made progress if it leaves less than this fraction of the edges that were too short before.
constexpr double minProgress = 0.98;
/// Largest length, in d_detail, that an edge may have after a collapse. Edges longer than d_detail are split
/// afterwards, into halves that are not shorter than d.
constexpr double slack = 1.3;
/// Edge length, in d_detail, of equilateral triangles as large as the mean triangle of a uniform mesh (measured).
constexpr double typicalEdge = 0.7;
/// Progress bar, 0 to 1: fraction of the distance to afterRounds that each round adds, and positions after all rounds
/// and after raising. The final check fills the rest.
constexpr double shareOfRound = 0.4, afterRounds = 0.7, afterRaising = 0.9;

class UniformRemesher
{
public:
    UniformRemesher(Mesh& mesh, const EdgeBounds& bounds, const JobControl& control)
        : m_mesh(mesh)
        , m_bounds(bounds)
        , m_control(control)
        , m_surface(mesh)
        , m_original(mesh)
    {}

    void run();

private:
    void evenRounds();
    void round(int number);
    void raise();
    std::vector<Slot> alongCurve() const;
    std::size_t patchSize() const;
    struct Pass
    {
        std::size_t shift = 0;   ///< shift of the patch borders along the curve, in vertices
        double share = 0;        ///< share of the progress, 0 to 1
        bool onlyUneven = false; ///< skip patches whose edges are all within the bounds
    };
    using Step = std::function<void(MeshEditor edit)>;
    void overPatches(const Pass& pass, const Step& step);
    void fillRegion(std::span<const Slot> vertices);
    bool isOutOfBounds() const;
    void doSoundly(const Step& step);
    void optimiseWith(MeshEditor edit);

    Mesh& m_mesh;
    EdgeBounds m_bounds;
    const JobControl& m_control;
    VerifiedMesh m_surface;
    ReferenceSurface m_original;
    Region m_region;
    bool m_onlySplits = false; ///< no collapses are left to do: only long edges are split
    double m_done = 0;
};

void UniformRemesher::run()
{
    if (evennessOf(m_mesh, m_bounds).isUniform())
        return;
    evenRounds();
    raise();
}

void UniformRemesher::evenRounds()
{
    Evenness before = evennessOf(m_mesh, m_bounds);
    for (int number = 0; number < maxRounds && !before.isUniform() && !m_control.isCancelled(); ++number) {
        m_onlySplits = number > 0 && !before.hasManyShort();
        round(number);
        const Evenness after = evennessOf(m_mesh, m_bounds);
        const bool progress = number == 0 || before.tooLong > 0 ||
                              static_cast<double>(after.tooShort) < minProgress * static_cast<double>(before.tooShort);
        if (after.tooLong == 0 && !progress)
            return;
        before = after;
    }
}

/// Returns the vertices in the order of the Morton curve, by their current positions: slots of new vertices are
/// arbitrary.
std::vector<Slot> UniformRemesher::alongCurve() const
{
    std::vector<std::pair<std::uint64_t, Slot>> keys;
    keys.reserve(m_mesh.live().vertices);
    for (const Slot v : m_mesh.vertices())
        keys.emplace_back(mortonCodeOf(m_mesh.latticePoint(v)), v);
    std::ranges::sort(keys);
    std::vector<Slot> order(keys.size());
    std::ranges::transform(keys, order.begin(), &std::pair<std::uint64_t, Slot>::second);
    return order;
}

/// Returns the number of vertices that a patch starts with. Smaller if the mesh gets much finer, because checks and
/// cancellation act on whole patches.
std::size_t UniformRemesher::patchSize() const
{
    const double growth = std::max(1.0, uniformFaces(areaOf(m_mesh), m_bounds.detail) / m_mesh.live().faces);
    return std::max(minPerPatch, static_cast<std::size_t>(verticesPerPatch / growth));
}

void UniformRemesher::round(int number)
{
    const double share = shareOfRound * (afterRounds - m_done);
    overPatches({number % 2 == 0 ? 0 : patchSize() / 2, share, number > 0},
                [&](MeshEditor edit) { optimiseWith(edit); });
}

void UniformRemesher::raise()
{
    overPatches({0, afterRaising - m_done, false}, [&](MeshEditor edit) {
        moveSoundly(edit, m_region, m_bounds, [&](Slot v) { return m_original.raisedPlace(m_mesh, m_bounds, v); });
    });
}

void UniformRemesher::overPatches(const Pass& pass, const Step& step)
{
    const std::vector<Slot> order = alongCurve();
    const std::size_t perPatch = patchSize();
    for (std::size_t end = perPatch - pass.shift, begin = 0; begin < order.size(); begin = end, end += perPatch) {
        if (m_control.isCancelled())
            return;
        end = std::min(end, order.size());
        fillRegion(std::span(order).subspan(begin, end - begin));
        if (!pass.onlyUneven || isOutOfBounds())
            doSoundly(step);
        m_control.reportProgress(m_done + pass.share * static_cast<double>(end) / static_cast<double>(order.size()));
    }
    m_done += pass.share;
}

/// Fills m_region with the given vertices, if they still exist, and their neighbours, so that every edge is within some
/// patch.
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
            found = (length2 > m_bounds.detail * m_bounds.detail && m_mesh.mayBeSplit(h / 2)) ||
                    (length2 < m_bounds.minimum * m_bounds.minimum && m_mesh.mayGo(h / 2));
        });
    });
    return found;
}

void UniformRemesher::doSoundly(const Step& step)
{
    {
        MeshTransaction transaction(m_surface, m_region);
        step(MeshEditor(m_mesh));
        if (transaction.commit())
            return;
    }
    step(MeshEditor(m_mesh, [&](const auto& operation) { return m_surface.tryOperation(operation); }));
}

void UniformRemesher::optimiseWith(MeshEditor edit)
{
    const auto evenPlace = [&](Slot v) { return m_original.evenPlace(m_mesh, m_bounds, v); };
    if (!m_onlySplits) {
        const EdgeBounds loose = {slack * m_bounds.detail, m_bounds.minimum};
        optimiseKeepingShape(edit, m_region, loose, evenPlace);
        moveSoundly(edit, m_region, m_bounds, evenPlace);
    }
    splitLongEdges(edit, m_region, m_bounds);
    // middles of edges are inside round shapes, so the new vertices must move to the surface
    moveSoundly(edit, m_region, m_bounds, evenPlace);
}
} // namespace

Evenness evennessOf(const Mesh& mesh, const EdgeBounds& bounds)
{
    Evenness evenness;
    for (const Slot e : mesh.edges()) {
        const double length2 =
            (mesh.point(mesh.to(2 * e)) - mesh.point(mesh.to(2 * e + 1))).cast<double>().squaredNorm();
        ++evenness.edges;
        evenness.tooLong += length2 > bounds.detail * bounds.detail && mesh.mayBeSplit(e) ? 1 : 0;
        evenness.tooShort += length2 < bounds.minimum * bounds.minimum && mesh.mayGo(e) ? 1 : 0;
    }
    return evenness;
}

double areaOf(const Mesh& mesh)
{
    double sum = 0;
    for (const Slot f : mesh.faces())
        sum += faceNormal(mesh, f).norm() / 2;
    return sum;
}

double uniformFaces(double area, double detailLength)
{
    const double edge = typicalEdge * detailLength;
    return area / (std::sqrt(3.0) / 4 * edge * edge);
}

void remeshUniformly(Mesh& mesh, const RemeshUniformly& command, ModelChange& change, const JobControl& control)
{
    const EdgeBounds bounds = edgeBounds(command.detailLength > 0 ? command.detailLength : mesh.uniformDetail());
    const double faces = uniformFaces(areaOf(mesh), bounds.detail);
    if (bounds.detail < mesh.lattice().minDetail() || faces > ModelLimits::maxFaces) {
        change.refusal = ModelRefusal::TooFine;
        change.faces = static_cast<std::size_t>(std::min(faces, 1e15));
        return;
    }
    UniformRemesher(mesh, bounds, control).run();
    if (control.isCancelled())
        return;
    const LatticeFit fit = fitToLattice(mesh.lattice(), placesOf(mesh), liveFaces(mesh), control);
    if (fit.unsnappable > 0 || fit.resnapped > 0) {
        change.refusal = ModelRefusal::FacesMeet;
        change.faces = fit.unsnappable;
    }
    MeshFrame frame = mesh.frame();
    frame.uniformDetail = bounds.detail;
    mesh.setFrame(frame);
}
} // namespace core
