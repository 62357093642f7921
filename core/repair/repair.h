#pragma once

#include "core/analysis/mesh_check.h"
#include "core/analysis/space_difference.h"
#include "core/analysis/surface_distance.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <optional>

namespace core
{
/// What to do where more than one outcome is right.
struct RepairOptions
{
    bool fillLargeHoles = true;    ///< else a surface with a hole longer than a quarter of it is refused
    bool innerAreCavities = false; ///< a part inside of another that faces outwards: a cavity, else it is filled
    bool canWrap = false;          ///< the whole may be made anew if nothing else keeps it
};

/// Measures of a surface: area and the volume that it winds around, in the model's unit, and parts that edges connect.
struct SurfaceMeasures
{
    double area = 0, volume = 0;
    std::size_t parts = 0;
};

/// What was done, in the order of the steps. Counts of what was found and repaired.
struct RepairReport
{
    std::size_t welded = 0;          ///< vertices that lay where others did, on the lattice
    std::size_t degenerateFaces = 0; ///< without area
    std::size_t duplicateFaces = 0;
    std::size_t joined = 0;        ///< open vertices at cracks, joined with others or with the edge that they lay on
    double joinedWithin = 0;       ///< the farthest of these, in the model's unit
    std::size_t turnedFaces = 0;   ///< that ran against most of their neighbours, or whose part faced inwards
    std::size_t membraneFaces = 0; ///< of sheets between other faces that are seen from nowhere outside: they went
    std::size_t sheets = 0;        ///< open parts that enclose nothing: they were left out
    double sheetLength = 0, sheetWidth = 0;              ///< of the largest, in the model's unit
    std::size_t holes = 0;                               ///< that were filled
    std::size_t largeHoles = 0;                          ///< of these, or that were the reason to refuse
    std::size_t innerParts = 0;                          ///< inside of others and facing outwards
    std::uint64_t intersections = 0;                     ///< pairs of faces that met before the first cut
    std::size_t rounds = 0;                              ///< of cutting the surface along its intersections
    std::size_t touchingEdges = 0, touchingVertices = 0; ///< at which parts were drawn apart
    std::size_t knots = 0;    ///< places where faces met again and again: a small solid covers each
    double widestKnot = 0;    ///< the diameter of the largest of these, in the model's unit
    std::size_t crumbs = 0;   ///< parts that cutting left, too small and thin to count: they went
    std::size_t unmasked = 0; ///< masked points that are gone; where a point is kept, so is its mask
    /// The surface was made anew from the space that it winds around, with edges of about this length. Missing: it was
    /// kept.
    std::optional<double> remeshedAt;

    Vec3 moved =
        Vec3::Zero(); ///< was added to each point, as the model lay far from the origin; distances are without that
    double size = 0;  ///< the longest side of the model
    /// Before: area and parts are those of the model without the sheets, the volume that of its surface once closed and
    /// turned outwards and, as if they were closed, of the sheets.
    SurfaceMeasures before, after;
    SurfaceDistance fromOld; ///< of the old surface, from the new one: what went
    SurfaceDistance fromNew; ///< of the new surface, from the old one: what was added, and what moved
    double hausdorff() const { return std::max(fromOld.largest, fromNew.largest); }
    static constexpr double leastVolume = 0.98, mostVolume = 1.02, mostLost = 0.005, mostSpaceLost = 0.02,
                            mostSpaceGained = 0.1, mostOtherSpace = 0.02;
    double lost = 0; ///< mean distance of the old surface from the new one, where it does not lie inside of that
    /// From the old surface if that was open: from the file's faces, or as they were turned where they run both ways
    /// along an edge; without sheets of 1/100 of the area or more.
    SpaceDifference space;
    SpaceDifference
        otherSpace; ///< measured from what it would be if parts that were turned are cavities, where they may be
    double keptVolume() const { return before.volume > 0 ? after.volume / before.volume : 1; }
    /// The model was not made anew, its volume is the same within 2 %, `lost` is at most 0.5 % of its size, and of the
    /// space that the old and the new surface enclose together at most 2 % were lost and 10 % gained, and 2 %
    /// differ from the other reading.
    bool isFaithful() const;
};

enum class RepairRefusal {
    None,
    LargeHoles,
    EnclosesNothing,
    Unresolved, ///< faces still meet or touch at RepairResult::place: it could only be made anew
    TooMuchLost ///< more than half of the volume: it could only be made anew
};

struct RepairResult
{
    std::optional<TriangleMesh> mesh; ///< print-ready, and on its lattice; missing if refused or stopped
    TriangleMesh old;                 ///< with `mesh`: the surface that it was held against, moved as `mesh` is
    RepairRefusal refusal = RepairRefusal::None;
    std::optional<Vec3> place; ///< if unresolved, in the model's coordinates
    RepairReport report;
};

enum class RepairStep { CleanUp, Stitch, Orient, Fill, Resolve, Remesh, Check, Measure };
/// Is told what begins, on the job's thread; some steps come again.
using RepairStepCallback = std::function<void(RepairStep step)>;

/// Makes one closed, manifold, consistently oriented surface without intersections out of whatever triangles there are:
/// the boundary of the space that they wind around. Away from what was wrong no coordinate changes but by the snap to
/// the lattice (half a unit), and where cracks close (crack_stitching.h). The caller asks isFaithful() whether the
/// outcome is still the model. Indices in range, points finite, at least one face. Whole-mesh cost, on all cores.
RepairResult repairMesh(const TriangleMesh& mesh, const RepairOptions& options = {}, const JobControl& control = {},
                        const RepairStepCallback& onStep = {});

/// Measures what became of a repaired model, such as fewer triangles, against `old` of its repair: `after`, `fromOld`,
/// `fromNew` and `lost` of the report, not `space`. The mesh is closed and oriented, and lies where `old` does. Cost:
/// that of checkMesh() and of two distanceFrom().
void measureAgain(RepairReport& report, const TriangleMesh& old, const TriangleMesh& mesh);
} // namespace core
