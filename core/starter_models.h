#pragma once

#include "triangle_mesh.h"

namespace core
{
enum class Starter { Ball, Cube, Torus, Slab, Vase, Head, Tablet };

inline constexpr Starter starters[] = {Starter::Ball,  Starter::Cube, Starter::Torus, Starter::Slab,
                                       Starter::Vase, Starter::Head, Starter::Tablet};

/// A model to begin with: closed, outward, about 10,000 vertices, 100 mm along its longest side, its middle at the origin,
/// upright along y and symmetric in x and z, bit for bit (a head in x only). The same bits everywhere.
TriangleMesh starterModel(Starter starter);
} // namespace core
