#pragma once

#include "triangle_mesh.h"

#include <optional>
#include <stop_token>

namespace core
{
/// A square picture of a model; nothing behind it.
struct ModelPicture
{
    int pixels = 0; ///< along a side
    std::vector<std::array<std::uint8_t, 4>> rgba; ///< sRGB, alpha multiplied in; rows from the top
};

/// The model from the front, the right and above, fitted into the picture, under two lamps, in its own colours or in those of clay.
/// Any triangles will do: open, crossing, turned to either side. A model without extent leaves the picture empty. Nothing if it was
/// stopped. Deterministic; any thread. Cost: three passes over the faces, and nine samples a pixel (256 pixels: some 30 ms, a
/// million vertices: 150 ms more).
std::optional<ModelPicture> drawPicture(const TriangleMesh& mesh, int pixels, const std::stop_token& stop);
} // namespace core
