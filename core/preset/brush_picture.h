#pragma once

#include "core/drawing/model_thumbnail.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Returns a square picture of what a brush does: one stroke of it, done by the engine on a ball of clay of 100 mm.
/// Tools that even out get a rough ball, tools that drag draw a horn out of it. Radius, symmetry, place and topology
/// are the picture's own. Nothing if it was stopped. Deterministic; any thread. Cost: 0.2 to 1.7 s, most of it the
/// strokes of alphas.
std::optional<ModelThumbnail> drawBrush(const StrokeSettings& brush, int pixels, const std::stop_token& stop);
} // namespace core
