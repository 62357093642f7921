#pragma once

namespace ui
{
/// Speeds of the turntable, degrees per second.
inline constexpr double minTurn = 1, maxTurn = 720, defaultTurn = 60;
} // namespace ui
