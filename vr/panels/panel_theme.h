#pragma once

#include <QColor>

/// Appearance of panels: dark and calm, so that they neither dazzle nor distract from the clay. Lengths are in dmm
/// (panel_layout.h).
namespace vr::theme
{
// Heights of text: 3.45 degrees for titles, and half of that for the smallest text. Practitioners recommend these
// heights for reading without effort in a headset.
inline constexpr double titleHeight = 60.3, bodyHeight = 34, minHeight = 30.2;
inline constexpr double lineSpacing = 1.22; ///< distance between lines, in heights of the text

inline constexpr double margin = 32, gap = 14, corner = 28, itemCorner = 14, outline = 3;
inline constexpr double titleRow = 84, row = 80;
inline constexpr double knobWidth = 22;
inline constexpr double iconHeight = 46;

inline const QColor ground(25, 27, 31, 244), rim(255, 255, 255, 44), well(15, 16, 19), field(48, 52, 59),
    fieldHovered(66, 72, 82), fieldPressed(36, 39, 45), chosen(45, 113, 176), chosenHovered(58, 131, 198),
    chosenPressed(37, 94, 148), text(232, 235, 239), faint(158, 166, 177), accent(122, 184, 240);
inline constexpr double dimmed = 0.36; ///< opacity of disabled items
} // namespace vr::theme
