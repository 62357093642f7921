#pragma once

namespace ui
{
/// Of the window's spacing grid, in pixels.
inline constexpr int gap = 8;
} // namespace ui
