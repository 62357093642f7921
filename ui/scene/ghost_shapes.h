#pragma once

#include "core/mesh/draw_arrays.h"

namespace ui
{
/// A head with a headset on it, about as large as people are: metres, the origin between the eyes, -Z ahead, +Y up. The
/// lighter a vertex, the more solid its part.
core::DrawArrays headShape();

/// Radius 1 about the origin.
core::DrawArrays ballShape();
} // namespace ui
