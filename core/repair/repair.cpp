// Whatever a stranger made becomes the boundary of a solid:
//   1. snap      to the lattice, and weld                                        tidy
//   2. tidy      faces without area, faces that are there twice                  tidy
//      join      cracks: open vertices as good as on others, or on open edges    seams
//   3. orient    along edges of two; sheets inside go                            orient
//   4. fill      holes                                                           holes
//   5. outwards  parts that face inwards                                         orient
//   6. resolve   cut along all intersections, keep the boundary of what is wound around, round to the lattice; again while
//                rounding makes faces meet                                       arrangement, solid
//   7. separate  parts that touch at edges and vertices; again from 6 if clay was added                  separate
//   8. judge     the whole; if it is not in order, or too much was lost, make it anew from the winding number    wrap
//   9. measure   how far it is from what it was                                  surface_distance
//      and mask  what was masked and is still there                              masks

#include "core/repair/repair.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"

#include "core/repair/hole_filling.h"
#include "core/repair/mask_transfer.h"
#include "core/repair/orientation.h"
#include "core/repair/crack_stitching.h"
#include "core/repair/contact_separation.h"
#include "core/repair/winding_solid.h"
#include "core/repair/cleanup.h"
#include "core/repair/shrink_wrap.h"

namespace core
{
namespace
{
using mending::Surface;

/// Shares of the time; most models need neither of the last two.
constexpr double afterMending = 0.2, afterFirstAttempt = 0.8, afterSecondAttempt = 0.9;

Surface surfaceOf(const TriangleMesh& mesh, const LatticePlacement& placement)
{
    Surface surface;
    surface.points.reserve(mesh.points.size());
    for (const Vec3f& p : mesh.points)
        surface.points.push_back(placement.toLattice(p));
    surface.colors = mesh.colors;
    surface.triangles = mesh.triangles;
    return surface;
}

TriangleMesh meshOf(Surface surface, const Lattice& lattice)
{
    mending::weld(surface);
    TriangleMesh mesh;
    mesh.points.reserve(surface.points.size());
    for (const LatticePoint& p : surface.points)
        mesh.points.push_back(lattice.toPoint(p));
    mesh.colors = std::move(surface.colors);
    mesh.triangles = std::move(surface.triangles);
    return mesh;
}

/// Who is told how far it is and what begins.
struct Told
{
    JobWatch watch;
    const LegaliseTell& tell;

    void begin(LegaliseStep step) const
    {
        if (tell)
            tell(step);
    }
    Told part(double from, double to) const { return {watch.part(from, to), tell}; }
};

/// What steps 1 to 5 come to.
struct Mended
{
    bool isRefused = false; ///< a large hole is not to be filled
    bool isLoose = false; ///< there was nearly as much to fill as there was to keep: triangles that hang together badly
    Surface unfilled;     ///< as it was before step 4
};

void weldAndTidy(Surface& surface, LegaliseReport& report)
{
    report.welded += mending::weld(surface);
    const mending::Tidied tidied = mending::tidy(surface, mending::Duplicates::KeepOne);
    report.degenerateFaces += tidied.degenerate;
    report.duplicateFaces += tidied.duplicates;
}

void join(Surface& surface, double unit, LegaliseReport& report)
{
    const mending::Joined joined = mending::joinSeams(surface);
    report.joined = joined.vertices;
    report.joinedWithin = joined.farthest * unit;
    if (joined.vertices > 0)
        weldAndTidy(surface, report);
}

Mended mend(Surface& surface, double unit, const LegaliseOptions& options, LegaliseReport& report, const Told& told)
{
    constexpr double nearlyAll = 0.75;
    constexpr double afterTidying = 0.3, afterJoining = 0.5, afterOrienting = 0.7, afterFilling = 0.8;
    const JobWatch& watch = told.watch;
    told.begin(LegaliseStep::Tidy);
    weldAndTidy(surface, report);
    watch.reached(afterTidying);
    told.begin(LegaliseStep::Join);
    join(surface, unit, report);
    watch.reached(afterJoining);
    told.begin(LegaliseStep::Orient);
    const mending::Oriented oriented = mending::orient(surface);
    report.turnedFaces = oriented.turned;
    report.membraneFaces = oriented.membranes;
    watch.reached(afterOrienting);
    told.begin(LegaliseStep::Fill);
    Mended mended;
    mended.unfilled = surface;
    const mending::Filled filled = mending::fillHoles(surface, options.fillLargeHoles, watch);
    watch.reached(afterFilling);
    report.holes = filled.holes;
    report.largeHoles = filled.largeHoles;
    mended.isRefused = filled.largeHoles > 0 && !options.fillLargeHoles;
    mended.isLoose = filled.share > nearlyAll;
    mending::tidy(surface, mending::Duplicates::Cancel);
    const mending::Faced faced = mending::faceOutwards(surface, options.innerAreCavities);
    report.turnedFaces += faced.turned;
    report.innerParts = faced.inner;
    watch.reached(1);
    return mended;
}

struct Resolved
{
    bool isDone = false; ///< it came to an end
    double insideOut = 0;
};

/// Step 6.
Resolved resolve(Surface& surface, mending::Inside inside, LegaliseReport& report, const JobWatch& watch)
{
    constexpr std::size_t mostRounds = 12;
    constexpr std::size_t mostPairs = 4'000'000;
    constexpr std::uint64_t manyMore = 10, fewEnough = 1000; // a tangle that grows with each rounding comes to no end
    constexpr double afterMeeting = 0.3, afterCutting = 0.6;
    Resolved resolved;
    report.rounds = 0;
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    double reached = 0;
    for (std::size_t round = 0; round < mostRounds && !watch.stopped(); ++round) {
        const JobWatch part = watch.part(reached, (1 + reached) / 2);
        reached = (1 + reached) / 2;
        const IntersectionReport met =
            selfIntersections<LatticePredicates>(surface.points, surface.triangles, mostPairs, watch.stop);
        if (round == 0)
            report.intersections = met.count;
        resolved.isDone = round > 0 && met.count == 0;
        part.reached(afterMeeting);
        if (resolved.isDone || met.count > mostPairs || (round > 0 && met.count > manyMore * fewest + fewEnough))
            break;
        fewest = std::min(fewest, met.count);
        report.rounds += met.count > 0;
        mending::Solid solid = mending::solidOf(surface, mending::arrange(surface, met.pairs, part.part(afterMeeting, afterCutting)), inside, part.part(afterCutting, 1));
        surface = std::move(solid.surface);
        inside = mending::Inside::Positive; // now it bounds what was asked for; what rounding turns inside out goes
        resolved.insideOut = std::max(resolved.insideOut, solid.insideOut);
        mending::tidy(surface, mending::Duplicates::Cancel);
    }
    return resolved;
}

/// Steps 6 and 7, as long as 7 adds something.
Resolved resolveAndSeparate(Surface& surface, mending::Inside inside, LegaliseReport& report, const JobWatch& watch)
{
    constexpr int mostTimes = 4;
    constexpr std::size_t mostDrops = 200; // more would be another model
    const Resolved resolved = resolve(surface, inside, report, watch);
    for (int time = 0; time < mostTimes && resolved.isDone && !watch.stopped(); ++time) {
        const MeshTopology topology = topologyOf(surface.points.size(), surface.triangles);
        if (topology.nonManifoldEdges.count + topology.nonManifoldVertices.count == 0)
            break;
        const mending::Separated separated = mending::separate(surface, watch);
        report.touchingEdges += separated.edges;
        report.touchingVertices += separated.vertices;
        if (separated.joined == 0)
            break;
        if (separated.joined > mostDrops)
            return {};
        LegaliseReport unread;
        mending::weld(surface);
        if (!resolve(surface, mending::Inside::Positive, unread, {watch.stop, {}}).isDone)
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
std::optional<Outcome> judged(Surface surface, const Lattice& lattice, const TriangleMesh& old, const Told& told)
{
    constexpr double afterCheck = 0.35, afterFromOld = 0.7;
    told.begin(LegaliseStep::Check);
    Outcome outcome{meshOf(std::move(surface), lattice), {}, {}};
    if (outcome.mesh.triangles.empty() || !checkMesh(outcome.mesh, told.watch.part(0, afterCheck)).printReady() || told.watch.stopped())
        return std::nullopt;
    told.begin(LegaliseStep::Measure);
    outcome.fromOld = distanceFrom(old, outcome.mesh, told.watch.part(afterCheck, afterFromOld));
    outcome.fromNew = distanceFrom(outcome.mesh, old, told.watch.part(afterFromOld, 1));
    return outcome;
}

TriangleMesh movedBy(const Vec3& by, TriangleMesh mesh)
{
    for (Vec3f& p : mesh.points)
        p = (p.cast<double>() + by).cast<float>();
    return mesh;
}
} // namespace

Legalised legalise(const TriangleMesh& mesh, const LegaliseOptions& options, const JobWatch& watch, const LegaliseTell& tell)
{
    const Told told{watch, tell};
    Legalised result;
    LegaliseReport& report = result.report;
    const Box box = boxOf(mesh);
    result.refusal = LegaliseRefusal::EnclosesNothing;
    if (box.sizes().maxCoeff() <= 0)
        return result;
    const LatticePlacement placement = placeOnLattice(box);
    report.moved = placement.moved;
    const TriangleMesh old = movedBy(placement.moved, mesh);
    Surface surface = surfaceOf(mesh, placement);
    const Mended mended = mend(surface, placement.lattice.unit(), options, report, told.part(0, afterMending));
    if (mended.isRefused) {
        result.refusal = LegaliseRefusal::LargeHoles;
        return result;
    }
    std::optional<Outcome> outcome;
    const auto attempt = [&](mending::Inside inside, const Told& part) {
        constexpr double afterResolving = 0.4;
        part.begin(LegaliseStep::Resolve);
        Surface attempted = surface;
        LegaliseReport itsReport = report;
        const Resolved resolved = resolveAndSeparate(attempted, inside, itsReport, part.watch.part(0, afterResolving));
        if (!resolved.isDone)
            return resolved;
        auto better = judged(std::move(attempted), placement.lattice, old, part.part(afterResolving, 1));
        if (better && (!outcome || better->fromOld.mean < outcome->fromOld.mean)) {
            outcome = std::move(better);
            report = itsReport;
        }
        return resolved;
    };
    constexpr double muchInsideOut = 0.2, muchLost = 0.01;
    const Resolved resolved = attempt(mending::Inside::Positive, told.part(afterMending, afterFirstAttempt));
    const bool isMuchLost = !outcome || outcome->fromOld.mean > muchLost * box.diagonal().norm();
    if (resolved.insideOut > muchInsideOut && isMuchLost && !watch.stopped())
        attempt(mending::Inside::NonZero, told.part(afterFirstAttempt, afterSecondAttempt));
    watch.reached(afterSecondAttempt);
    if ((!outcome || mended.isLoose) && !watch.stopped() && !mended.unfilled.triangles.empty()) {
        constexpr double afterWrapping = 0.4;
        const Told part = told.part(afterSecondAttempt, 1);
        part.begin(LegaliseStep::Remesh);
        const int cell = mending::cellFor(mended.unfilled);
        auto anew = judged(mending::wrap(mended.unfilled, cell, part.watch.part(0, afterWrapping)), placement.lattice, old, part.part(afterWrapping, 1));
        if (anew && (!outcome || anew->fromOld.mean < outcome->fromOld.mean)) {
            outcome = std::move(anew);
            report.remeshedAt = cell * placement.lattice.unit();
        }
    }
    if (watch.stopped() || !outcome)
        return result;
    report.fromOld = outcome->fromOld;
    report.fromNew = outcome->fromNew;
    result.mesh = std::move(outcome->mesh);
    report.unmasked = mending::keepMasks(mesh, placement, *result.mesh);
    result.refusal = LegaliseRefusal::None;
    watch.reached(1);
    return result;
}
} // namespace core
