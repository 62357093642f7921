#pragma once

#include "core/geometry/triangle_mesh.h"

#include <optional>
#include <string_view>

namespace core
{
enum class Starter { Ball, Cube, Torus, Slab, Vase, Head, Tablet };

inline constexpr Starter starters[] = {Starter::Ball, Starter::Cube, Starter::Torus, Starter::Slab,
                                       Starter::Vase, Starter::Head, Starter::Tablet};

/// As lesson files name them: "ball".
std::string_view name(Starter starter);
std::optional<Starter> starterNamed(std::string_view name);

/// A model to begin with: closed, outward, about 10,000 vertices, 100 mm along its longest side, its middle at the
/// origin, upright along y and symmetric in x and z, bit for bit (a head in x only). The same bits everywhere.
TriangleMesh starterModel(Starter starter);
} // namespace core
