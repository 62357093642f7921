#pragma once

#include "core/geometry/triangle_mesh.h"

#include <optional>
#include <stop_token>

namespace core
{
/// A picture of a model on a transparent background.
struct ModelThumbnail
{
    int width = 0, height = 0;                     ///< pixels
    std::vector<std::array<std::uint8_t, 4>> rgba; ///< sRGB with premultiplied alpha; rows from the top
};

/// The camera and the size of a picture.
struct ThumbnailView
{
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< unit rows: right, up, and towards the eye
    Vec3 target = Vec3::Zero();                         ///< the point in the middle of the picture
    /// Distance from the eye to the target, mm; 0: parallel projection.
    double distance = 0;
    /// Height of the visible part of the plane through the target, mm.
    double extent = 100;
    int width = 0, height = 0; ///< pixels
};

/// Draws a square picture of the model, seen from the front, right and above, and fitted into the picture. Two lamps
/// light it; colours are the model's own or clay. The mesh may be open, self-intersecting and inconsistently oriented.
/// A model without extent gives an empty picture. Returns nothing if it was stopped. Deterministic. Thread: any. Cost:
/// three passes over the faces, and nine samples a pixel (about 30 ms for 256 x 256 pixels, 150 ms more for a million
/// vertices).
std::optional<ModelThumbnail> drawThumbnail(const TriangleMesh& mesh, int pixels, const std::stop_token& stop);

/// Draws the model as drawThumbnail() above, with the given camera. Parts outside the picture are clipped; faces that
/// extend behind the eye are omitted. Cost: four samples a pixel (about 300 ms for 1920 x 1080 pixels).
std::optional<ModelThumbnail> drawThumbnail(const TriangleMesh& mesh, const ThumbnailView& view,
                                            const std::stop_token& stop);

/// Returns a camera that fits the box into the picture, in the viewing direction of the square thumbnails.
ThumbnailView viewOf(const Box& box, int width, int height);
} // namespace core
