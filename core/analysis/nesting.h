#pragma once

#include "core/geometry/geometry.h"
#include "core/geometry/lattice.h"

#include <span>
#include <vector>

namespace core
{
/// Do these shells bound a solid: does each face outwards at even nesting depth and inwards at odd? Exact: signs of
/// volumes and parities of rays. The triangles must be closed, manifold, consistently oriented within each shell, not
/// degenerate, and free of intersections. Cost: O(faces), and a tree of boxes if there is more than one shell.
bool boundsSolid(std::span<const Vec3f> points, std::span<const Triangle> triangles);
bool boundsSolid(std::span<const LatticePoint> points, std::span<const Triangle> triangles);

/// The sets of faces connected by vertices, numbered by their first faces. In a manifold mesh these are its shells.
struct Components
{
    std::vector<Slot> ofFace;
    std::size_t count = 0;
};
Components componentsOf(std::size_t vertices, std::span<const Triangle> triangles);

/// How many sets of faces are connected by edges: parts that touch at a point are parts. Slower.
std::size_t edgeComponents(std::span<const Triangle> triangles);
} // namespace core
