#pragma once

#include "core/geometry/triangle_mesh.h"

#include <optional>
#include <stop_token>

namespace core
{
/// A picture of a model; nothing behind it.
struct ModelThumbnail
{
    int width = 0, height = 0;                     ///< pixels
    std::vector<std::array<std::uint8_t, 4>> rgba; ///< sRGB, alpha multiplied in; rows from the top
};

/// From where the model is seen, and how large the picture is.
struct ThumbnailView
{
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< rows of unit length: to the right, up, to the eye
    Vec3 target = Vec3::Zero();                         ///< in the picture's middle
    /// Of the eye from the target; 0: parallel light, as far away as you like.
    double distance = 0;
    /// That the picture's height shows of a plane through the target.
    double extent = 100;
    int width = 0, height = 0; ///< pixels
};

/// Square. The model from the front, the right and above, fitted into the picture, under two lamps, in its own colours
/// or in those of clay. Any triangles will do: open, crossing, turned to either side. A model without extent leaves the
/// picture empty. Nothing if it was stopped. Deterministic; any thread. Cost: three passes over the faces, and nine
/// samples a pixel (256 pixels: some 30 ms, a million vertices: 150 ms more).
std::optional<ModelThumbnail> drawThumbnail(const TriangleMesh& mesh, int pixels, const std::stop_token& stop);

/// The same, seen as `view` says; what does not fit is cut off at the borders, and faces that reach behind the eye are
/// left out. Four samples a pixel (1920 x 1080: some 300 ms).
std::optional<ModelThumbnail> drawThumbnail(const TriangleMesh& mesh, const ThumbnailView& view,
                                            const std::stop_token& stop);

/// As drawThumbnail() of a square looks, at something of that box.
ThumbnailView viewOf(const Box& box, int width, int height);
} // namespace core
