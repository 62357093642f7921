#pragma once

#include "core/analysis/mesh_check.h"
#include "core/analysis/space_difference.h"
#include "core/analysis/surface_distance.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <optional>

namespace core
{
/// The user's choices where more than one result would be right.
struct RepairOptions
{
    bool fillLargeHoles = true; ///< otherwise a surface with a hole longer than a quarter of the surface is refused
    /// A part inside another that faces outwards becomes a cavity; otherwise it is filled.
    bool innerAreCavities = false;
    bool canWrap = false; ///< the whole surface may be remeshed if nothing else preserves it
};

/// Measures of a surface in the model's unit: area, enclosed volume by winding number, and number of parts connected by
/// edges.
struct SurfaceMeasures
{
    double area = 0, volume = 0;
    std::size_t parts = 0;
};

/// A record of what the repair found and changed, in the order of its steps.
struct RepairReport
{
    std::size_t welded = 0;          ///< vertices merged with others at the same lattice point
    std::size_t degenerateFaces = 0; ///< faces without area
    std::size_t duplicateFaces = 0;
    std::size_t joined = 0;      ///< open vertices at cracks, joined with others or with an edge near them
    double joinedWithin = 0;     ///< largest distance of a joined vertex, in the model's unit
    std::size_t turnedFaces = 0; ///< faces that disagreed with most of their neighbours, or whose part faced inwards
    /// Removed faces of open parts between other faces that are not visible from outside.
    std::size_t membraneFaces = 0;
    std::size_t sheets = 0;                 ///< removed open parts that enclose nothing
    double sheetLength = 0, sheetWidth = 0; ///< size of the largest sheet, in the model's unit
    std::size_t holes = 0;                  ///< number of filled holes
    /// Number of large holes: filled, or the reason why the model was refused.
    std::size_t largeHoles = 0;
    std::size_t innerParts = 0; ///< parts that are inside others and face outwards
    /// Pairs of faces on each other within rounding: joined if they belong to bodies that touch, removed if they are
    /// the sides of a sheet without thickness.
    std::size_t contacts = 0;
    std::uint64_t intersections = 0; ///< pairs of faces that met before the first cut
    /// Number of times that the surface was cut along its intersections.
    std::size_t rounds = 0;
    std::size_t touchingEdges = 0, touchingVertices = 0; ///< contacts at which parts were separated
    std::size_t knots = 0;    ///< places where faces kept meeting; each is covered by a small solid
    double widestKnot = 0;    ///< diameter of the largest of these solids, in the model's unit
    std::size_t crumbs = 0;   ///< removed parts that are too small and thin to count
    std::size_t unmasked = 0; ///< masked points that no longer exist; a point that is kept keeps its mask
    /// Edge length of the remeshed surface, in the model's unit, if the surface was remeshed from its winding number.
    /// Missing if it was kept.
    std::optional<double> remeshedAt;

    /// Translation added to each point, because the model was far from the origin. Distances in this report do not
    /// include it.
    Vec3 moved = Vec3::Zero();
    double size = 0; ///< longest side of the model
    /// `before`: area and parts are those of the model without the sheets. Its volume is that of the surface once
    /// closed and turned outwards, plus that of the sheets as if they were closed.
    SurfaceMeasures before, after;
    SurfaceDistance fromOld; ///< distances of the old surface from the new one: what was removed
    SurfaceDistance fromNew; ///< distances of the new surface from the old one: what was added or moved
    double hausdorff() const { return std::max(fromOld.largest, fromNew.largest); }
    static constexpr double minVolume = 0.98, maxVolume = 1.02, maxLost = 0.005, maxSpaceLost = 0.02,
                            maxSpaceGained = 0.1, maxOtherSpace = 0.02, maxSingleSpace = 0.02;
    /// Mean distance of the old surface from the new one, in the model's unit. If it exceeds maxLost x size, it is
    /// measured again, and points of the old surface inside the new one count as distance 0.
    double lost = 0;
    /// Compares the enclosed space with that of the old surface, if the old surface was open. Uses the faces of the
    /// file, or the oriented faces if the file is not oriented. Sheets of 1/100 of the area or more are left out.
    SpaceDifference space;
    /// Compares the enclosed space with the one that results if doubtful parts are taken for cavities instead.
    SpaceDifference otherSpace;
    /// Compares the enclosed space with that of the file's faces, each sheet once (single_sheets.h), if sheets may have
    /// coincided and the file's faces run one way.
    SpaceDifference singleSpace;
    double keptVolume() const { return before.volume > 0 ? after.volume / before.volume : 1; }
    /// Returns whether the result is still the same model: it was not remeshed, its volume is the same within 2 %, and
    /// `lost` is at most 0.5 % of its size. It lost at most 2 % of the space that the old and the new surface enclose
    /// together, and gained at most 10 %. At most 2 % differ in the alternative reading, and at most 2 % from the space
    /// of each sheet once.
    bool isFaithful() const;
    /// Returns whether the mean distance of the old surface from the new one is at most 0.5 % of the size. A faithful
    /// result may exceed it: surface inside it was removed, such as where bodies overlapped.
    bool keepsSurface() const { return fromOld.mean <= maxLost * size; }
};

enum class RepairRefusal {
    None,
    LargeHoles,
    EnclosesNothing,
    /// Faces still meet or touch: only remeshing would help.
    Unresolved,
    TooMuchLost ///< more than half of the volume would be lost: only remeshing would help
};

struct RepairResult
{
    std::optional<TriangleMesh> mesh; ///< print-ready and on its lattice; missing if refused or stopped
    /// The surface with which `mesh` was compared, moved as `mesh` is; set only with `mesh`.
    TriangleMesh old;
    RepairRefusal refusal = RepairRefusal::None;
    /// Place of the failure if unresolved, otherwise of the largest hole, in the model's coordinates. Set only if
    /// refused and if there is such a place.
    std::optional<Vec3> place;
    RepairReport report;
};

enum class RepairStep { CleanUp, Stitch, Orient, Fill, Resolve, Remesh, Check, Measure };
/// Called on the job's thread when a step begins; some steps are repeated.
using RepairStepCallback = std::function<void(RepairStep step)>;

/// Makes one closed, manifold, consistently oriented surface without intersections from any triangles: the boundary of
/// the space that they wind around. Away from defects, coordinates change only by the snap to the lattice (half a unit)
/// and where cracks are closed (crack_stitching.h). Callers must check isFaithful(). Precondition: indices are in
/// range, points are finite, and there is at least one face. Cost: O(mesh), on all cores.
RepairResult repairMesh(const TriangleMesh& mesh, const RepairOptions& options = {}, const JobControl& control = {},
                        const RepairStepCallback& onStep = {});

/// Measures a repaired model after a further change, such as decimation, against `old` of its repair. Updates `after`,
/// `fromOld`, `fromNew` and `lost` of the report, not `space`. Precondition: the mesh is print-ready, and in
/// the same position as `old`. Cost: that of checkMesh() and of two distanceFrom().
void measureAgain(RepairReport& report, const TriangleMesh& old, const TriangleMesh& mesh);
} // namespace core
