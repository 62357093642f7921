#pragma once

#include "core/sculpt/dab_context.h"
#include "core/sculpt/solid_boolean.h"

namespace core
{
/// The outcome of a boolean dab. Apart: the surfaces do not cross. Masked: masked faces would be removed. Apart, Masked
/// and Failed leave the surface as it is; with a solid that is its own mirror image, Masked and Failed may have split
/// edges across the plane.
enum class BooleanOutcome { Done, Apart, Masked, Failed };

/// A solid of one or two shells, and the positions at which the dab is to place its points.
struct PlacedSolid
{
    /// `places`: positions of the mesh's points, mm. `center`: retries grow the solid away from this point.
    PlacedSolid(TriangleMesh ofMesh, std::vector<Vec3> ofPlaces, const Vec3& center);

    TriangleMesh mesh;
    std::vector<Vec3> places;
    /// for each point, the direction in which retries move it: the signs of its coordinates relative to the centre
    std::vector<Vec3> outward;
};

/// Unites the model with a solid, or subtracts the solid from it, as one step that counts as one fusion. Then makes the
/// mesh near the cut quasi-uniform; the curves in which the surfaces met stay sharp. The context's region becomes the
/// changed vertices. With a mirror the solid's image is united or subtracted too, unless the solid is its own image.
/// Fails if the solid and its image would change the same faces, or if the solid leaves the working volume.
BooleanOutcome applyBoolean(DabContext& context, PlacedSolid solid, BooleanOperation operation);
/// Unites the model with a solid as applyBoolean() does. If that fails with a mirror, unites the solid and its image in
/// one operation. Its result is not exactly symmetric, so the report is marked asymmetric.
BooleanOutcome uniteOnBothSides(DabContext& context, PlacedSolid solid);
} // namespace core
