#pragma once

#include "core/geometry/triangle_mesh.h"

#include <optional>
#include <string_view>

namespace core
{
enum class Starter { Ball, Cube, Torus, Slab, Vase, Head, Tablet };

inline constexpr Starter starters[] = {Starter::Ball, Starter::Cube, Starter::Torus, Starter::Slab,
                                       Starter::Vase, Starter::Head, Starter::Tablet};

/// Returns the name used in lesson files, for example "ball".
std::string_view name(Starter starter);
std::optional<Starter> starterNamed(std::string_view name);

/// Returns a starter model: closed, oriented outward, about 10,000 vertices, longest side 100 mm, centred at the
/// origin, upright along y. Symmetric in x and z bit for bit (the head in x only). The same bits on every machine.
TriangleMesh starterModel(Starter starter);
} // namespace core
