#pragma once

#include "core/drawing/depth_image.h"
#include "core/drawing/feature_edges.h"

namespace core
{
/// Depth images of what each side hides, indexed by DrawnSide.
using DepthImages = std::array<DepthImage, 3>;

/// Images that hold the box; `pixel`: mm.
DepthImages depthImagesOf(const Box& box, float pixel);

/// Brings the images up to date and draws the model's lines, each side on a thread of its own. Nothing if it was
/// stopped. Cost: the images' expired tiles, the edges of the scan.
std::optional<LineDrawing> drawingOf(const DrawArrays& model, const FeatureScan& scan, DepthImages& images, bool shaded,
                                     const std::stop_token& stop);
} // namespace core
