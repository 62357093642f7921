#pragma once

namespace ui
{
/// Unit of the window's spacing grid, pixels.
inline constexpr int gap = 8;
} // namespace ui
