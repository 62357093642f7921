#pragma once

namespace ui
{
enum class DrawnSides { All, Front, Right, Top };

struct DrawingSettings
{
    DrawnSides sides = DrawnSides::All;
    bool shaded = false; ///< colours under the lines
    bool dimensions = true;
    friend bool operator==(const DrawingSettings&, const DrawingSettings&) = default;
};
} // namespace ui
