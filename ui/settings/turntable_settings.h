#pragma once

namespace ui
{
/// Degrees a second.
inline constexpr double minTurn = 1, maxTurn = 720, defaultTurn = 60;
} // namespace ui
