#pragma once

#include "core/drawing/model_thumbnail.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Returns a square picture of one stroke of the brush, sculpted by the engine on a clay ball of 100 mm diameter.
/// Smoothing tools get a rough ball; drag tools pull a horn out of the ball; an anchored brush drags one dab. Radius,
/// symmetry, placement and topology are chosen for the picture. Returns nothing if it was stopped. Deterministic.
/// Thread: any. Cost: 0.2 to 1.7 s, the most for brushes with an alpha.
std::optional<ModelThumbnail> drawBrush(const StrokeSettings& brush, int pixels, const std::stop_token& stop);
} // namespace core
