#pragma once

#include "core/geometry/geometry.h"
#include "core/geometry/lattice.h"

#include <span>
#include <vector>

namespace core
{
/// Returns whether the shells bound a solid: each faces outwards at even nesting depth and inwards at odd depth. Exact:
/// uses signs of volumes and parities of ray crossings. Precondition: the triangles are closed, manifold and
/// consistently oriented within each shell, not degenerate, and free of intersections. Cost: O(faces), and a tree of
/// boxes if there is more than one shell.
bool boundsSolid(std::span<const Vec3f> points, std::span<const Triangle> triangles);
bool boundsSolid(std::span<const LatticePoint> points, std::span<const Triangle> triangles);

/// Sets of faces connected by vertices, numbered by their first faces. In a manifold mesh they are its shells.
struct Components
{
    std::vector<Slot> ofFace;
    std::size_t count = 0;
};
Components componentsOf(std::size_t vertices, std::span<const Triangle> triangles);

/// Returns the connected pieces of a solid: each is a shell that faces outwards, with the shells of the voids directly
/// inside it. Precondition: the shells bound a solid. Cost: O(faces), and a tree of boxes if there is more than one
/// shell.
Components solidPiecesOf(std::span<const Vec3f> points, std::span<const Triangle> triangles);

/// Returns the number of sets of faces connected by edges: parts that touch only at a vertex count separately. Slower
/// than componentsOf().
std::size_t edgeComponents(std::span<const Triangle> triangles);
} // namespace core
