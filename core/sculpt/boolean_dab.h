#pragma once

#include "core/sculpt/dab_context.h"
#include "core/sculpt/solid_boolean.h"

namespace core
{
/// The outcome of a boolean dab. Apart: the surfaces do not meet. Masked: masked faces would go, too. All but Done
/// leave everything as it was.
enum class BooleanOutcome { Done, Apart, Masked, Failed };

/// A solid of one or two shells, and where a dab wants it.
struct PlacedSolid
{
    /// `places`: of its points, in mm. `center`: it grows away from there.
    PlacedSolid(TriangleMesh ofMesh, std::vector<Vec3> ofPlaces, const Vec3& center);
    /// Adds its mirror image as a second shell, which may meet the first.
    void addImage(const MirrorMap& mirror);

    TriangleMesh mesh;
    std::vector<Vec3> places;
    std::vector<Vec3> outward; ///< for each point the signs of the coordinates of the way out
};

/// Unites the model with a solid, or subtracts the solid from it, as one step that counts as one fusion, and makes the
/// mesh there quasi-uniform; the curves in which the surfaces met stay sharp. The context's region becomes what was
/// changed. A mirror has the solid's image done, too; then it fails where the solid and its image change the same
/// faces. It fails beyond the working volume, too.
BooleanOutcome applyBoolean(DabContext& context, PlacedSolid solid, BooleanOperation operation);
/// Unites the model with a solid as applyBoolean() does. Where a mirror fails, unites it with the solid and its image
/// at once, which is not exactly symmetric, and says so in the report.
BooleanOutcome uniteOnBothSides(DabContext& context, PlacedSolid solid);
} // namespace core
