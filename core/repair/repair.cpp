// Makes the boundary of a solid from any triangles:
//   1. snap      to the lattice, and weld                                        cleanup
//   2. clean up  remove faces without area, and duplicate faces                  cleanup
//      drop      parts that exist twice with different triangles                 doubled_parts
//      join      cracks: open vertices near others or near open edges            crack_stitching
//   3. orient    along edges of two faces; remove hidden sheets                  orientation
//   4. leave out open parts that enclose nothing                                 sheet_removal
//      fill      holes                                                           hole_filling
//   5. outwards  turn parts that face inwards                                    orientation
//      offset    walls that coincide within rounding                             outward_offset
//   6. resolve   cut along all intersections, keep the boundary of the enclosed space, round to the lattice;
//                cover what does not converge; separate parts that touch at edges and vertices         resolution
//   7. check     the whole; if it is invalid and may be remeshed, remesh from the winding number     shrink_wrap
//   8. measure   the distance from the original                                  surface_distance, space_difference
//      and mask  copy the masks of points that still exist                       mask_transfer

#include "core/repair/repair.h"

#include "core/analysis/nesting.h"
#include "core/analysis/single_sheets.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"

#include "core/repair/cleanup.h"
#include "core/repair/crack_stitching.h"
#include "core/repair/doubled_parts.h"
#include "core/repair/edge_faces.h"
#include "core/repair/hole_filling.h"
#include "core/repair/mask_transfer.h"
#include "core/repair/orientation.h"
#include "core/repair/outward_offset.h"
#include "core/repair/resolution.h"
#include "core/repair/sheet_removal.h"
#include "core/repair/shrink_wrap.h"

#include <cmath>
#include <iterator>
#include <map>

namespace core
{
namespace
{
using repair::TriangleSoup;

/// Progress, 0 to 1, at the end of steps 1 to 5 and of step 6.
constexpr double afterClosing = 0.2, afterResolving = 0.9;

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

/// Reports progress, and which step begins.
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

/// Returns whether the faces surround some space, connected or not: the pyramids from their mean point to the faces
/// have a volume of more than 0.01 x area^1.5. A cube has 0.07.
bool standAroundSpace(const TriangleSoup& surface)
{
    constexpr double least = 0.01;
    const auto at = [&](Slot v) { return Vec3(surface.points[v].cast<double>()); };
    Vec3 middle = Vec3::Zero();
    for (const Triangle& t : surface.triangles)
        middle += (at(t[0]) + at(t[1]) + at(t[2])) / (3 * static_cast<double>(surface.triangles.size()));
    double volume = 0, area = 0;
    for (const Triangle& t : surface.triangles) {
        const Vec3 doubleArea = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
        volume += (at(t[0]) - middle).dot(doubleArea) / 6;
        area += doubleArea.norm() / 2;
    }
    return std::abs(volume) > least * std::pow(area, 1.5);
}

/// The result of steps 1 to 5.
struct ClosedSurface
{
    bool isRefused = false; ///< there is a large hole that must not be filled
    /// The filled area is more than 3/4 of the area before: the triangles are badly connected.
    bool isLoose = false;
    std::optional<Vec3> largestHole; ///< lattice units
    TriangleSoup unfilled;           ///< the surface before holes were filled, without sheets
    /// The surface as the file has it, including all removed parts except large sheets. Missing if the file is closed.
    std::optional<TriangleSoup> whole;
    /// The closed surface, with parts reversed that may as well be cavities. Missing if there are none.
    std::optional<TriangleSoup> otherReading;
    TriangleSoup cavities;      ///< parts of the surface that face inwards
    bool isFileOriented = true; ///< the two faces of each edge run along it in opposite directions
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

/// Returns whether the faces run along each edge equally often in both directions.
bool isClosed(const TriangleSoup& surface)
{
    bool isClosed = true;
    repair::forEachEdge(surface.triangles, [&](std::span<const repair::EdgeFace> around) {
        std::size_t forward = 0;
        for (const repair::EdgeFace& e : around)
            forward += e.forward ? 1 : 0;
        isClosed = isClosed && 2 * forward == around.size();
    });
    return isClosed;
}

/// Drops faces and patches that exist twice, in either orientation. Returns the number of dropped faces.
std::size_t dropDoubles(TriangleSoup& surface)
{
    const std::size_t faces = repair::cleanUp(surface, repair::Duplicates::KeepOne).duplicates;
    return faces + repair::dropDoubledPatches(surface).size();
}

/// Accepts a surface that is closed and oriented and has no double faces, after cancelling opposite ones. Opposite
/// faces belong to parts that touch, which may enclose a void. Other doubles are dropped if the surface is closed
/// without them. Otherwise, or if a component would disappear, returns false and does not change the surface.
bool takeClosed(TriangleSoup& surface, RepairReport& report)
{
    TriangleSoup taken = surface;
    const std::size_t welded = repair::weld(taken);
    const Components before = componentsOf(taken.points.size(), taken.triangles);
    std::vector<bool> isKept(before.count, false);
    std::vector<Slot> componentOf(taken.points.size(), 0);
    for (Slot f = 0; f < taken.triangles.size(); ++f)
        for (const Slot v : taken.triangles[f])
            componentOf[v] = before.ofFace[f];
    repair::CleanupResult cleaned = repair::cleanUp(taken, repair::Duplicates::Cancel);
    for (const Triangle& t : taken.triangles)
        isKept[componentOf[t[0]]] = true;
    if (std::ranges::find(isKept, false) != isKept.end() || !isClosed(taken))
        return false;
    TriangleSoup single = taken;
    const std::size_t doubles = dropDoubles(single);
    if (doubles > 0 && isClosed(single)) {
        taken = std::move(single);
        cleaned.duplicates += doubles;
    } else if (repair::hasDoubles(taken)) {
        return false;
    }
    surface = std::move(taken);
    report.welded += welded;
    report.degenerateFaces += cleaned.degenerate;
    report.duplicateFaces += cleaned.duplicates;
    return true;
}

/// Returns whether the two faces of each edge of two run along it in opposite directions.
bool runsOneWay(std::span<const Triangle> triangles)
{
    bool doRun = true;
    repair::forEachEdge(triangles, [&](std::span<const repair::EdgeFace> around) {
        doRun = doRun && (around.size() != 2 || around[0].forward != around[1].forward);
    });
    return doRun;
}

/// Returns whether any edge has more than two faces.
bool hasSharedEdges(std::span<const Triangle> triangles)
{
    bool isAnyShared = false;
    repair::forEachEdge(
        triangles, [&](std::span<const repair::EdgeFace> around) { isAnyShared = isAnyShared || around.size() > 2; });
    return isAnyShared;
}

/// Drops faces that have the same corners as any of these.
void dropFaces(TriangleSoup& surface, std::vector<Triangle> faces)
{
    for (Triangle& t : faces)
        t = repair::sortedCorners(t);
    std::ranges::sort(faces);
    std::erase_if(surface.triangles,
                  [&](const Triangle& t) { return std::ranges::binary_search(faces, repair::sortedCorners(t)); });
}

/// Orients faces like the faces of `other` with the same corners.
void takeOrientation(TriangleSoup& surface, const TriangleSoup& other)
{
    std::map<Triangle, Triangle> byCorners;
    for (const Triangle& t : other.triangles)
        byCorners.emplace(repair::sortedCorners(t), t);
    for (Triangle& t : surface.triangles)
        if (const auto found = byCorners.find(repair::sortedCorners(t)); found != byCorners.end())
            t = found->second;
}

/// Closes a surface, except for holes that must not be filled.
ClosedSurface stitchAndFill(TriangleSoup& surface, double unit, const RepairOptions& options, RepairReport& report,
                            const Progress& progress)
{
    constexpr double nearlyAll = 0.75;
    constexpr double afterStitching = 0.4, afterOrienting = 0.6;
    progress.begin(RepairStep::CleanUp);
    weldAndCleanUp(surface, report);
    progress.begin(RepairStep::Stitch);
    join(surface, unit, report);
    report.duplicateFaces += repair::dropDoubledPatches(surface).size();
    progress.control.reportProgress(afterStitching);
    progress.begin(RepairStep::Orient);
    ClosedSurface result;
    result.whole = surface;
    result.isFileOriented = runsOneWay(surface.triangles);
    const repair::OrientationResult oriented = repair::orient(surface);
    report.turnedFaces = oriented.turned;
    report.membraneFaces = oriented.membranes.size();
    if (!result.isFileOriented) {
        result.whole = surface;
        std::ranges::copy(oriented.membranes, std::back_inserter(result.whole->triangles));
    }
    progress.control.reportProgress(afterOrienting);
    progress.begin(RepairStep::Fill);
    const repair::SheetRemoval removed = repair::removeSheets(surface, progress.control);
    report.sheets = removed.sheets;
    report.sheetLength = removed.length * unit;
    report.sheetWidth = removed.width * unit;
    report.before.volume = removed.volume * std::pow(unit, 3);
    dropFaces(*result.whole, removed.largeOnes);
    result.unfilled = surface;
    const repair::HoleFillingResult filled =
        repair::fillHoles(surface, options.fillLargeHoles, repair::Covering::Avoided, progress.control);
    report.holes = filled.holes;
    report.largeHoles = filled.largeHoles;
    result.isRefused = filled.largeHoles > 0 && !options.fillLargeHoles;
    result.isLoose = filled.share > nearlyAll;
    result.largestHole = filled.largest;
    repair::cleanUp(surface, repair::Duplicates::Cancel);
    return result;
}

ClosedSurface closeSurface(TriangleSoup& surface, double unit, const RepairOptions& options, RepairReport& report,
                           const Progress& progress)
{
    constexpr double afterFilling = 0.8;
    ClosedSurface result;
    if (takeClosed(surface, report))
        result.unfilled = surface;
    else
        result =
            stitchAndFill(surface, unit, options, report, {progress.control.part(0, afterFilling), progress.onStep});
    const std::vector<Triangle> doubled = repair::dropDoubledShells(surface);
    report.duplicateFaces += doubled.size();
    if (result.whole)
        dropFaces(*result.whole, doubled);
    const repair::OutwardResult faced = repair::orientOutwards(surface, options.innerAreCavities);
    if (result.whole && !result.isFileOriented)
        takeOrientation(*result.whole, surface);
    report.turnedFaces += faced.turned;
    report.innerParts = faced.inner;
    if (!faced.guesses.empty())
        result.otherReading = surface;
    for (const Slot f : faced.guesses)
        std::swap(result.otherReading->triangles[f][1], result.otherReading->triangles[f][2]);
    if (!faced.cavities.empty())
        result.cavities = {surface.points, {}, faced.cavities};
    progress.control.reportProgress(1);
    return result;
}

/// Returns the least area that the holes of an oriented surface can have, as a share of the surface's area.
double shareOfHoles(const TriangleMesh& mesh)
{
    double area = 0;
    Vec3 sum = Vec3::Zero(); // area vectors of a closed surface add up to zero
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const auto& [a, b, c] = cornersOf(mesh, f);
        const Vec3 doubleArea = (b - a).cross(c - a);
        area += doubleArea.norm();
        sum += doubleArea;
    }
    return area > 0 ? sum.norm() / area : 1;
}

/// Returns the faces of a file, each sheet once, if any sheets can coincide. Returns nothing if it is unclear what
/// these faces enclose: the file's faces do not run one way, or their holes have over 1/6 of the area, such as where a
/// loose sheet faces another one.
std::optional<TriangleMesh> sheetsOf(TriangleSoup file, const Lattice& lattice, const RepairReport& report)
{
    constexpr double nearby = 16;        // lattice units, as in doubled_parts.h
    constexpr double maxHoles = 1.0 / 6; // share of the area
    TriangleMesh all = meshOf(std::move(file), lattice);
    const bool isAnyDropped = report.duplicateFaces + report.membraneFaces > 0;
    if (!(isAnyDropped || hasSharedEdges(all.triangles)) || !runsOneWay(all.triangles))
        return std::nullopt;
    TriangleMesh single = singleSheets(all, nearby * lattice.unit());
    return shareOfHoles(single) > maxHoles ? std::nullopt : std::optional(std::move(single));
}

/// A valid surface, and its distance from the original.
struct Outcome
{
    TriangleMesh mesh;
    RepairReport report;

    /// Returns how much the surface differs from the original, 0 if it is equal. Terms are relative to the model's size
    /// or volume.
    double loss() const
    {
        return std::abs(1 - report.keptVolume()) + report.lost / report.size + report.space.lost + report.space.gained +
               report.singleSpace.lost + report.singleSpace.gained;
    }
};

TriangleMesh movedBy(const Vec3& by, TriangleMesh mesh)
{
    for (Vec3f& p : mesh.points)
        p = (p.cast<double>() + by).cast<float>();
    return mesh;
}

/// Performs step 8. `measures`: report of checkMesh() for `mesh`.
void measure(RepairReport& report, const TriangleMesh& old, const TriangleMesh& mesh, const MeshReport& measures,
             const JobControl& control = {})
{
    constexpr double half = 0.5;
    constexpr double near = 1e-4; // share of the size within which a point counts as on the surface
    report.after = {measures.area, measures.volume.value_or(0), measures.components};
    report.fromOld = distanceFrom(old, mesh, control.part(0, half));
    report.fromNew = distanceFrom(mesh, old, control.part(half, 1));
    report.lost = report.fromOld.mean;
    if (report.lost > RepairReport::maxLost * report.size) // some of the old surface may have been inside
        report.lost = meanDistanceOutside(old, mesh, near * report.size, {control.stop, {}});
}

double total(const SpaceDifference& difference)
{
    return difference.lost + difference.gained;
}

/// The surfaces with which the result is compared.
struct Originals
{
    TriangleMesh old;
    std::optional<TriangleMesh> sheets; ///< the file's faces, each sheet once
};

/// Performs steps 6 to 8.
class Solidification
{
public:
    /// `report`: report of steps 1 to 5. Keeps references, except to the report.
    Solidification(const TriangleSoup& surface, const ClosedSurface& closed, const Lattice& lattice,
                   const Originals& originals, const repair::ContactOffset& offset, const RepairReport& report)
        : m_surface(surface)
        , m_closed(closed)
        , m_lattice(lattice)
        , m_originals(originals)
        , m_offset(offset)
        , m_report(report)
    {
        const TriangleMesh& old = originals.old;
        m_report.before.parts = edgeComponents(old.triangles);
        for (const Triangle& t : old.triangles) {
            const Vec3 a = old.points[t[0]].cast<double>(), b = old.points[t[1]].cast<double>(),
                       c = old.points[t[2]].cast<double>();
            m_report.before.area += (b - a).cross(c - a).norm() / 2;
        }
    }

    /// Resolves the space with positive winding number, then with either sign if space of negative winding number was
    /// lost. Repeats both with a larger tolerance if they do not converge.
    void resolve(const Progress& progress)
    {
        constexpr double tolerances[] = {2, 64, 1024}; // lattice units; the last may be 1/200 of the size
        constexpr double shareOfAttempt = 0.75;        // share of the remaining progress; most models need one attempt
        std::uint64_t budget = 200'000;                // pairs of faces that may be cut again; takes tens of seconds
        double reached = 0;
        for (const double tolerance : tolerances) {
            for (const repair::Inside inside : {repair::Inside::Positive, repair::Inside::NonZero}) {
                if (m_resolution.intersections > budget)
                    return;
                budget -= m_resolution.intersections; // another attempt cuts all of them again
                const double next = reached + shareOfAttempt * (1 - reached);
                attempt(inside, tolerance, budget, progress.part(reached, next));
                reached = next;
                if (progress.control.isCancelled() || !isInsideOut())
                    break;
            }
            if (progress.control.isCancelled() || m_volume <= 0 || m_best)
                break;
        }
    }

    void wrap(const Progress& progress)
    {
        constexpr double afterShrinkWrap = 0.4;
        progress.begin(RepairStep::Remesh);
        if (refusal() != RepairRefusal::None)
            m_best.reset();
        const int cell = repair::cellFor(m_closed.unfilled);
        RepairReport report = m_report;
        report.before.volume += m_volume;
        report.remeshedAt = cell * m_lattice.unit();
        offer(repair::shrinkWrap(m_closed.unfilled, cell, progress.control.part(0, afterShrinkWrap)), report,
              progress.part(afterShrinkWrap, 1));
    }

    bool isFaithful() const { return m_best && m_best->report.isFaithful(); }
    /// Returns why there is no result, or none that is good enough.
    RepairRefusal refusal() const
    {
        constexpr double half = 0.5, maxDistance = 0.05;
        const bool wasCut = m_resolution.rounds > 0 || m_resolution.intersections == 0;
        if (!m_best && m_volume <= 0 && wasCut)
            return m_closed.isLoose && standAroundSpace(m_closed.unfilled) ? RepairRefusal::TooMuchLost
                                                                           : RepairRefusal::EnclosesNothing;
        if (!m_best)
            return RepairRefusal::Unresolved;
        const RepairReport& report = m_best->report;
        const bool isOther = m_closed.isLoose || report.remeshedAt;
        const bool isFar = isOther && report.lost > maxDistance * report.size;
        return report.keptVolume() < half || isFar ? RepairRefusal::TooMuchLost : RepairRefusal::None;
    }
    /// Returns the place of a failure, in lattice units.
    std::optional<Vec3> unresolvedPlace() const
    {
        if (!m_resolution.unresolved)
            return std::nullopt;
        return Vec3(m_resolution.unresolved->cast<double>());
    }
    Outcome& best() { return *m_best; }

private:
    void attempt(repair::Inside inside, double tolerance, std::uint64_t& budget, const Progress& progress)
    {
        constexpr double afterCutting = 0.4;
        progress.begin(RepairStep::Resolve);
        TriangleSoup surface = m_surface;
        m_resolution = repair::resolveIntersections(surface, inside, m_closed.cavities, tolerance, budget,
                                                    progress.control.part(0, afterCutting));
        const double volume = m_resolution.volume + lostInsideOut() - m_offset.addedVolume;
        m_volume = std::max(m_volume, volume * std::pow(m_lattice.unit(), 3)); // the volume is 0 if nothing was cut
        RepairReport report = m_report;
        report.before.volume += m_volume;
        report.intersections = m_resolution.intersections;
        report.rounds = m_resolution.rounds;
        report.touchingEdges = m_resolution.touchingEdges;
        report.touchingVertices = m_resolution.touchingVertices;
        report.knots = m_resolution.knots;
        report.crumbs = m_resolution.crumbs;
        report.widestKnot = m_resolution.widestKnot * m_lattice.unit();
        if (m_resolution.isDone)
            offer(std::move(surface), report, progress.part(afterCutting, 1));
    }

    /// Returns the volume with negative winding number, without that of sheets that the offset has turned inside out.
    double lostInsideOut() const { return std::max(0., m_resolution.insideOutVolume - m_offset.invertedVolume); }

    /// Returns whether the surface was resolved but space with negative winding number was lost.
    bool isInsideOut() const
    {
        return m_resolution.isDone && lostInsideOut() > 0 &&
               (!m_best || m_best->report.keptVolume() < RepairReport::minVolume);
    }

    /// Keeps the surface as the best outcome if it is valid and loses less than the best one so far.
    void offer(TriangleSoup surface, const RepairReport& report, const Progress& progress)
    {
        constexpr double afterCheck = 0.35, afterMeasuring = 0.9;
        progress.begin(RepairStep::Check);
        Outcome outcome{meshOf(std::move(surface), m_lattice), report};
        if (outcome.mesh.triangles.empty())
            return;
        const MeshReport measures = checkMesh(outcome.mesh, progress.control.part(0, afterCheck));
        if (!measures.printReady() || progress.control.isCancelled())
            return;
        progress.begin(RepairStep::Measure);
        measure(outcome.report, m_originals.old, outcome.mesh, measures,
                progress.control.part(afterCheck, afterMeasuring));
        constexpr double afterComparing = (1 + afterMeasuring) / 2;
        if (m_closed.whole)
            outcome.report.space = spaceDifferences(meshOf(*m_closed.whole, m_lattice), outcome.mesh,
                                                    progress.control.part(afterMeasuring, afterComparing))
                                       .eitherWay;
        if (m_closed.otherReading)
            outcome.report.otherSpace = spaceDifferences(meshOf(*m_closed.otherReading, m_lattice), outcome.mesh,
                                                         progress.control.part(afterComparing, 1))
                                            .outwards;
        if (m_originals.sheets)
            outcome.report.singleSpace = differenceFromSheets(outcome.mesh, progress.control);
        if (!progress.control.isCancelled() && (!m_best || outcome.loss() < m_best->loss()))
            m_best = std::move(outcome);
    }

    /// Returns the lesser difference: parts that face inwards may be cavities, or turned parts. Returns no difference
    /// if the two spaces have nothing in common: the body itself has cancelled, as one of two copies faces inwards.
    SpaceDifference differenceFromSheets(const TriangleMesh& solid, const JobControl& control) const
    {
        constexpr double nearlyAll = 0.99;
        const auto [eitherWay, outwards] = spaceDifferences(*m_originals.sheets, solid, {control.stop, {}});
        if (total(eitherWay) <= RepairReport::maxSingleSpace)
            return eitherWay;
        const SpaceDifference least = total(outwards) < total(eitherWay) ? outwards : eitherWay;
        return total(least) < nearlyAll ? least : SpaceDifference{};
    }

    const TriangleSoup& m_surface;
    const ClosedSurface& m_closed;
    const Lattice& m_lattice;
    const Originals& m_originals;
    repair::ContactOffset m_offset;
    RepairReport m_report;
    repair::Resolution m_resolution;
    double m_volume = 0; ///< volume that the surface winds around, cubic units of the model
    std::optional<Outcome> m_best;
};
} // namespace

bool RepairReport::isFaithful() const
{
    return !remeshedAt && keptVolume() >= minVolume && keptVolume() <= maxVolume && lost <= maxLost * size &&
           space.lost <= maxSpaceLost && space.gained <= maxSpaceGained &&
           otherSpace.lost + otherSpace.gained <= maxOtherSpace &&
           singleSpace.lost + singleSpace.gained <= maxSingleSpace;
}

RepairResult repairMesh(const TriangleMesh& mesh, const RepairOptions& options, const JobControl& control,
                        const RepairStepCallback& onStep)
{
    const Progress progress{control, onStep};
    RepairResult result;
    RepairReport& report = result.report;
    const Box box = boxOf(mesh);
    result.refusal = RepairRefusal::EnclosesNothing;
    report.size = box.sizes().maxCoeff();
    if (report.size <= 0)
        return result;
    const LatticePlacement placement = placeOnLattice(box);
    report.moved = placement.moved;
    TriangleSoup surface = surfaceOf(mesh, placement);
    const ClosedSurface closed =
        closeSurface(surface, placement.lattice.unit(), options, report, progress.part(0, afterClosing));
    if (closed.isRefused)
        result.refusal = RepairRefusal::LargeHoles;
    const auto setPlace = [&](const std::optional<Vec3>& onLattice) {
        if (onLattice)
            result.place = placement.lattice.unit() * *onLattice - placement.moved;
    };
    setPlace(closed.largestHole);
    if (closed.isRefused || closed.unfilled.triangles.empty() || control.isCancelled())
        return result;
    Originals originals;
    originals.old = report.sheets > 0 ? meshOf(closed.unfilled, placement.lattice) : movedBy(placement.moved, mesh);
    if (!closed.isLoose)
        originals.sheets = sheetsOf(surfaceOf(mesh, placement), placement.lattice, report);
    const repair::ContactOffset offset = repair::offsetContacts(surface, control.stop);
    report.contacts = offset.pairs;
    Solidification solid(surface, closed, placement.lattice, originals, offset, report);
    solid.resolve(progress.part(afterClosing, afterResolving));
    control.reportProgress(afterResolving);
    if (options.canWrap && !solid.isFaithful() && !control.isCancelled())
        solid.wrap(progress.part(afterResolving, 1));
    if (control.isCancelled())
        return result;
    result.refusal = solid.refusal();
    if (result.refusal == RepairRefusal::Unresolved)
        setPlace(solid.unresolvedPlace());
    if (result.refusal != RepairRefusal::None)
        return result;
    result.place.reset();
    report = std::move(solid.best().report);
    result.mesh = std::move(solid.best().mesh);
    report.unmasked = repair::transferMasks(mesh, placement, *result.mesh);
    result.old = std::move(originals.old);
    control.reportProgress(1);
    return result;
}

void measureAgain(RepairReport& report, const TriangleMesh& old, const TriangleMesh& mesh)
{
    measure(report, old, mesh, checkMesh(mesh));
}
} // namespace core
