#pragma once

#include "core/boolean/mesh_boolean.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/lattice_placement.h"
#include "core/repair/triangle_soup.h"

namespace core::boolean
{
constexpr std::size_t facesPerChunk = 1 << 13; ///< number of faces that a core takes at a time

/// All solids of an operation on one lattice, one after the other.
struct SolidSoup
{
    LatticePlacement placement;
    repair::TriangleSoup surface;  ///< faces of solids that are subtracted are turned over
    std::vector<Slot> firstPoints; ///< first point of each solid, then the number of all points
    std::vector<Slot> firstFaces;  ///< first face of each solid, then the number of all faces
    std::vector<LatticeBox> boxes; ///< one per solid
    int least = 1;                 ///< lowest winding number of `surface` around space that the result holds
    bool isDifference = false;

    std::size_t solids() const { return boxes.size(); }
    std::size_t solidOf(Slot face) const
    {
        return static_cast<std::size_t>(std::ranges::upper_bound(firstFaces, face) - firstFaces.begin()) - 1;
    }
    /// Returns the winding number of a solid's faces around its inside.
    int windingOf(std::size_t solid) const { return isDifference && solid > 0 ? -1 : 1; }

    std::array<LatticePoint, 3> cornersOf(Slot face) const
    {
        const Triangle& t = surface.triangles[face];
        return {surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
    }
    LatticeBox boxOf(Slot face) const
    {
        LatticeBox box;
        for (const LatticePoint& p : cornersOf(face))
            box.extend(p);
        return box;
    }
    /// Returns the point in the solids' coordinates; exact in float32.
    Vec3f pointAt(const LatticePoint& p) const
    {
        return (placement.lattice.toPoint(p).cast<double>() - placement.moved).cast<float>();
    }
};

/// Returns the box for a BoxTree, grown by a margin in lattice units.
inline FaceBox floatBox(const LatticeBox& box, float margin = 0)
{
    return {box.min.array().cast<float>() - margin, box.max.array().cast<float>() + margin};
}

/// Puts the solids on the lattice of an import, 2^finer times finer (`finer`: 0 to 2). Far from the origin, the lattice
/// is no finer than float32 numbers are there.
SolidSoup soupOf(SetOperation operation, std::span<const TriangleMesh> solids, int finer = 0);
/// Puts the solids on a lattice. Precondition: it contains them.
SolidSoup soupOn(const LatticePlacement& placement, SetOperation operation, std::span<const TriangleMesh> solids);
} // namespace core::boolean
