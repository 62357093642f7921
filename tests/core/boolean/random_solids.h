#pragma once

#include "core/geometry/triangle_mesh.h"

#include <string>

/// A pair of print-ready solids.
struct SolidPair
{
    std::string kind;
    core::TriangleMesh a, b;
    bool canTouch = false; ///< whether faces, edges or points of both may coincide
};

/// Returns the random pair of a seed. The kinds take turns: rotated, boxes and tetrahedra on a coarse grid, coplanar
/// faces, nested, identical, nearly identical, touching at a point, needles, rough, far from the origin.
SolidPair randomPair(unsigned seed);
