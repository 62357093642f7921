// Whatever a stranger made becomes the boundary of a solid:
//   1. snap      to the lattice, and weld                                        cleanup
//   2. clean up  faces without area, faces that are there twice                  cleanup
//      join      cracks: open vertices as good as on others, or on open edges    crack_stitching
//   3. orient    along edges of two; sheets inside go                            orientation
//   4. fill      holes                                                           hole_filling
//   5. outwards  parts that face inwards                                         orientation
//   6. resolve   cut along all intersections, keep the boundary of what is wound around, round to the lattice; again
//   while
//                rounding makes faces meet                                       arrangement, winding_solid
//   7. separate  parts that touch at edges and vertices; again from 6 if material was added contact_separation
//   8. check     the whole; if it is not in order, or too much was lost, make it anew from the winding number
//   shrink_wrap
//   9. measure   how far it is from what it was                                  surface_distance
//      and mask  what was masked and is still there                              mask_transfer

#include "core/repair/repair.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"

#include "core/repair/cleanup.h"
#include "core/repair/contact_separation.h"
#include "core/repair/crack_stitching.h"
#include "core/repair/hole_filling.h"
#include "core/repair/mask_transfer.h"
#include "core/repair/orientation.h"
#include "core/repair/shrink_wrap.h"
#include "core/repair/winding_solid.h"

namespace core
{
namespace
{
using repair::TriangleSoup;

/// Shares of the time; most models need neither of the last two.
constexpr double afterClosing = 0.2, afterFirstAttempt = 0.8, afterSecondAttempt = 0.9;

TriangleSoup surfaceOf(const TriangleMesh& mesh, const LatticePlacement& placement)
{
    TriangleSoup surface;
    surface.points.reserve(mesh.points.size());
    for (const Vec3f& p : mesh.points)
        surface.points.push_back(placement.toLattice(p));
    surface.colors = mesh.colors;
    surface.triangles = mesh.triangles;
    return surface;
}

TriangleMesh meshOf(TriangleSoup surface, const Lattice& lattice)
{
    repair::weld(surface);
    TriangleMesh mesh;
    mesh.points.reserve(surface.points.size());
    for (const LatticePoint& p : surface.points)
        mesh.points.push_back(lattice.toPoint(p));
    mesh.colors = std::move(surface.colors);
    mesh.triangles = std::move(surface.triangles);
    return mesh;
}

/// Who is told how far it is and what begins.
struct Progress
{
    JobControl control;
    const RepairStepCallback& onStep;

    void begin(RepairStep step) const
    {
        if (onStep)
            onStep(step);
    }
    Progress part(double from, double to) const { return {control.part(from, to), onStep}; }
};

/// What steps 1 to 5 come to.
struct ClosedSurface
{
    bool isRefused = false; ///< a large hole is not to be filled
    bool isLoose = false; ///< there was nearly as much to fill as there was to keep: triangles that hang together badly
    TriangleSoup unfilled; ///< as it was before step 4
};

void weldAndCleanUp(TriangleSoup& surface, RepairReport& report)
{
    report.welded += repair::weld(surface);
    const repair::CleanupResult cleaned = repair::cleanUp(surface, repair::Duplicates::KeepOne);
    report.degenerateFaces += cleaned.degenerate;
    report.duplicateFaces += cleaned.duplicates;
}

void join(TriangleSoup& surface, double unit, RepairReport& report)
{
    const repair::StitchResult joined = repair::stitchCracks(surface);
    report.joined = joined.vertices;
    report.joinedWithin = joined.farthest * unit;
    if (joined.vertices > 0)
        weldAndCleanUp(surface, report);
}

ClosedSurface closeSurface(TriangleSoup& surface, double unit, const RepairOptions& options, RepairReport& report,
                           const Progress& progress)
{
    constexpr double nearlyAll = 0.75;
    constexpr double afterCleanup = 0.3, afterStitching = 0.5, afterOrienting = 0.7, afterFilling = 0.8;
    const JobControl& control = progress.control;
    progress.begin(RepairStep::CleanUp);
    weldAndCleanUp(surface, report);
    control.reportProgress(afterCleanup);
    progress.begin(RepairStep::Stitch);
    join(surface, unit, report);
    control.reportProgress(afterStitching);
    progress.begin(RepairStep::Orient);
    const repair::OrientationResult oriented = repair::orient(surface);
    report.turnedFaces = oriented.turned;
    report.membraneFaces = oriented.membranes;
    control.reportProgress(afterOrienting);
    progress.begin(RepairStep::Fill);
    ClosedSurface closed;
    closed.unfilled = surface;
    const repair::HoleFillingResult filled = repair::fillHoles(surface, options.fillLargeHoles, control);
    control.reportProgress(afterFilling);
    report.holes = filled.holes;
    report.largeHoles = filled.largeHoles;
    closed.isRefused = filled.largeHoles > 0 && !options.fillLargeHoles;
    closed.isLoose = filled.share > nearlyAll;
    repair::cleanUp(surface, repair::Duplicates::Cancel);
    const repair::OutwardResult faced = repair::orientOutwards(surface, options.innerAreCavities);
    report.turnedFaces += faced.turned;
    report.innerParts = faced.inner;
    control.reportProgress(1);
    return closed;
}

struct Resolved
{
    bool isDone = false; ///< it came to an end
    double insideOut = 0;
};

/// Step 6.
Resolved resolve(TriangleSoup& surface, repair::Inside inside, RepairReport& report, const JobControl& control)
{
    constexpr std::size_t maxRounds = 12;
    constexpr std::size_t maxPairs = 4'000'000;
    constexpr std::uint64_t manyMore = 10, fewEnough = 1000; // a tangle that grows with each rounding comes to no end
    constexpr double afterMeeting = 0.3, afterCutting = 0.6;
    Resolved resolved;
    report.rounds = 0;
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    double reached = 0;
    for (std::size_t round = 0; round < maxRounds && !control.isCancelled(); ++round) {
        const JobControl part = control.part(reached, (1 + reached) / 2);
        reached = (1 + reached) / 2;
        const IntersectionReport met =
            selfIntersections<LatticePredicates>(surface.points, surface.triangles, maxPairs, control.stop);
        if (round == 0)
            report.intersections = met.count;
        resolved.isDone = round > 0 && met.count == 0;
        part.reportProgress(afterMeeting);
        if (resolved.isDone || met.count > maxPairs || (round > 0 && met.count > manyMore * fewest + fewEnough))
            break;
        fewest = std::min(fewest, met.count);
        report.rounds += met.count > 0;
        repair::WindingSolid solid =
            repair::windingSolidOf(surface, repair::arrange(surface, met.pairs, part.part(afterMeeting, afterCutting)),
                                   inside, part.part(afterCutting, 1));
        surface = std::move(solid.surface);
        inside = repair::Inside::Positive; // now it bounds what was asked for; what rounding turns inside out goes
        resolved.insideOut = std::max(resolved.insideOut, solid.insideOut);
        repair::cleanUp(surface, repair::Duplicates::Cancel);
    }
    return resolved;
}

/// Steps 6 and 7, as long as 7 adds something.
Resolved resolveAndSeparate(TriangleSoup& surface, repair::Inside inside, RepairReport& report,
                            const JobControl& control)
{
    constexpr int maxTimes = 4;
    constexpr std::size_t maxDrops = 200; // more would be another model
    const Resolved resolved = resolve(surface, inside, report, control);
    for (int time = 0; time < maxTimes && resolved.isDone && !control.isCancelled(); ++time) {
        const MeshTopology topology = topologyOf(surface.points.size(), surface.triangles);
        if (topology.nonManifoldEdges.count + topology.nonManifoldVertices.count == 0)
            break;
        const repair::SeparationResult separated = repair::separateContacts(surface, control);
        report.touchingEdges += separated.edges;
        report.touchingVertices += separated.vertices;
        if (separated.joined == 0)
            break;
        if (separated.joined > maxDrops)
            return {};
        RepairReport unread;
        repair::weld(surface);
        if (!resolve(surface, repair::Inside::Positive, unread, {control.stop, {}}).isDone)
            return {};
    }
    return resolved;
}

/// A surface that is in order, and how far it is from what it was.
struct Outcome
{
    TriangleMesh mesh;
    SurfaceDistance fromOld, fromNew;
};

/// Steps 8 and 9; nothing if it is not in order.
std::optional<Outcome> checked(TriangleSoup surface, const Lattice& lattice, const TriangleMesh& old,
                               const Progress& progress)
{
    constexpr double afterCheck = 0.35, afterFromOld = 0.7;
    progress.begin(RepairStep::Check);
    Outcome outcome{meshOf(std::move(surface), lattice), {}, {}};
    if (outcome.mesh.triangles.empty() || !checkMesh(outcome.mesh, progress.control.part(0, afterCheck)).printReady() ||
        progress.control.isCancelled())
        return std::nullopt;
    progress.begin(RepairStep::Measure);
    outcome.fromOld = distanceFrom(old, outcome.mesh, progress.control.part(afterCheck, afterFromOld));
    outcome.fromNew = distanceFrom(outcome.mesh, old, progress.control.part(afterFromOld, 1));
    return outcome;
}

TriangleMesh movedBy(const Vec3& by, TriangleMesh mesh)
{
    for (Vec3f& p : mesh.points)
        p = (p.cast<double>() + by).cast<float>();
    return mesh;
}
} // namespace

RepairResult repairMesh(const TriangleMesh& mesh, const RepairOptions& options, const JobControl& control,
                        const RepairStepCallback& onStep)
{
    const Progress progress{control, onStep};
    RepairResult result;
    RepairReport& report = result.report;
    const Box box = boxOf(mesh);
    result.refusal = RepairRefusal::EnclosesNothing;
    if (box.sizes().maxCoeff() <= 0)
        return result;
    const LatticePlacement placement = placeOnLattice(box);
    report.moved = placement.moved;
    const TriangleMesh old = movedBy(placement.moved, mesh);
    TriangleSoup surface = surfaceOf(mesh, placement);
    const ClosedSurface closed =
        closeSurface(surface, placement.lattice.unit(), options, report, progress.part(0, afterClosing));
    if (closed.isRefused) {
        result.refusal = RepairRefusal::LargeHoles;
        return result;
    }
    std::optional<Outcome> outcome;
    const auto attempt = [&](repair::Inside inside, const Progress& part) {
        constexpr double afterResolving = 0.4;
        part.begin(RepairStep::Resolve);
        TriangleSoup attempted = surface;
        RepairReport itsReport = report;
        const Resolved resolved =
            resolveAndSeparate(attempted, inside, itsReport, part.control.part(0, afterResolving));
        if (!resolved.isDone)
            return resolved;
        auto better = checked(std::move(attempted), placement.lattice, old, part.part(afterResolving, 1));
        if (better && (!outcome || better->fromOld.mean < outcome->fromOld.mean)) {
            outcome = std::move(better);
            report = itsReport;
        }
        return resolved;
    };
    constexpr double muchInsideOut = 0.2, muchLost = 0.01;
    const Resolved resolved = attempt(repair::Inside::Positive, progress.part(afterClosing, afterFirstAttempt));
    const bool isMuchLost = !outcome || outcome->fromOld.mean > muchLost * box.diagonal().norm();
    if (resolved.insideOut > muchInsideOut && isMuchLost && !control.isCancelled())
        attempt(repair::Inside::NonZero, progress.part(afterFirstAttempt, afterSecondAttempt));
    control.reportProgress(afterSecondAttempt);
    if ((!outcome || closed.isLoose) && !control.isCancelled() && !closed.unfilled.triangles.empty()) {
        constexpr double afterShrinkWrap = 0.4;
        const Progress part = progress.part(afterSecondAttempt, 1);
        part.begin(RepairStep::Remesh);
        const int cell = repair::cellFor(closed.unfilled);
        auto anew = checked(repair::shrinkWrap(closed.unfilled, cell, part.control.part(0, afterShrinkWrap)),
                            placement.lattice, old, part.part(afterShrinkWrap, 1));
        if (anew && (!outcome || anew->fromOld.mean < outcome->fromOld.mean)) {
            outcome = std::move(anew);
            report.remeshedAt = cell * placement.lattice.unit();
        }
    }
    if (control.isCancelled() || !outcome)
        return result;
    report.fromOld = outcome->fromOld;
    report.fromNew = outcome->fromNew;
    result.mesh = std::move(outcome->mesh);
    report.unmasked = repair::transferMasks(mesh, placement, *result.mesh);
    result.refusal = RepairRefusal::None;
    control.reportProgress(1);
    return result;
}
} // namespace core
