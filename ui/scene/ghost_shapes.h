#pragma once

#include "core/mesh/draw_arrays.h"

namespace ui
{
/// Returns a life-size head with a headset. Units: metres; origin between the eyes, -Z ahead, +Y up. The lighter a
/// vertex, the more solid its part is drawn.
core::DrawArrays headShape();

/// Returns a ball of radius 1 about the origin.
core::DrawArrays ballShape();
} // namespace ui
