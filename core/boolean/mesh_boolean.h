#pragma once

#include "core/analysis/mesh_check.h"
#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <optional>
#include <span>

namespace core
{
/// The space that the result holds. All operations are regularised: surfaces, edges and points without space behind
/// them are dropped (Requicha 1980, "Representations for rigid solids").
enum class SetOperation {
    Union,       ///< space in any of the solids
    Difference,  ///< space in the first solid and in none of the others
    Intersection ///< space in each of the solids
};

enum class BooleanRefusal {
    None,
    LeavesNothing, ///< no space is left
    Unresolved,    ///< faces near BooleanResult::place still meet after rounding, however often they are cut
    Stopped        ///< the job was cancelled
};

struct BooleanResult
{
    std::optional<TriangleMesh> mesh; ///< print-ready; missing if refused
    BooleanRefusal refusal = BooleanRefusal::None;
    std::optional<Vec3> place; ///< if unresolved, a place where faces meet, in the solids' coordinates
    MeshReport report;         ///< checkMesh() of `mesh`
};

/// Returns the union, difference or intersection of solids. Method: Zhou, Grinspun, Zorin and Jacobson 2016, "Mesh
/// arrangements for solid geometry": faces are cut exactly along their intersections, and pieces are kept by their
/// winding numbers.
///
/// Precondition: at least one solid; each is print-ready (MeshReport); all have one unit and frame. The result is in
/// the same frame. New points are rounded by at most half a unit of the lattice that an import of all solids together
/// would have. If rounded faces meet, they are cut again. If that comes to no end, or moves the surface by more than a
/// unit on average, a lattice two or four times finer is used; both happen with needles some 20 units thick. An import
/// of such a result may have to repair it. If surfaces nearly coincide, nearer points of faces that meet are merged,
/// within 2, 16 or 128 units. Points of faces that no other solid meets keep their coordinates bit for bit. Solids that
/// share a face are joined. Where the result would touch itself at an edge or a point, it is separated by a few units.
/// New points have colours between those of their face; a solid without colours gets the default colour if another has
/// colours. Masks are dropped.
///
/// Thread: any; uses all cores. The result does not depend on their number. Cost: a tree of boxes where solids overlap,
/// quadratic in the number of faces that meet one face, and checkMesh() of the result.
BooleanResult combine(SetOperation operation, std::span<const TriangleMesh> solids, const JobControl& control = {});
/// Combines the solids on the given lattice, which has all points of the result. No finer lattice is tried, so more
/// needles and surfaces that nearly coincide are merged within 2, 16 or 128 units. Precondition: all points of the
/// solids are on the lattice.
BooleanResult combineOn(const Lattice& lattice, SetOperation operation, std::span<const TriangleMesh> solids,
                        const JobControl& control = {});
} // namespace core
