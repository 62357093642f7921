#pragma once

#include "core/drawing/depth_image.h"
#include "core/drawing/feature_edges.h"

namespace core
{
/// The depth image of each side, indexed by DrawnSide.
using DepthImages = std::array<DepthImage, 3>;

/// Returns images whose grids cover the box. `pixel`: size of a pixel, mm.
DepthImages depthImagesOf(const Box& box, float pixel);

/// Updates the depth images and draws the model's lines, each side on a thread of its own. Returns nothing if it was
/// stopped. Cost: the images' expired tiles and the edges of the scan.
std::optional<LineDrawing> drawingOf(const DrawArrays& model, const FeatureScan& scan, DepthImages& images, bool shaded,
                                     const std::stop_token& stop);
} // namespace core
