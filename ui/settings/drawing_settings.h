#pragma once

namespace ui
{
enum class DrawnSides { All, Front, Right, Top };

struct DrawingChoice
{
    DrawnSides sides = DrawnSides::All;
    bool shaded = false; ///< colours under the lines
    bool dimensions = true;
    friend bool operator==(const DrawingChoice&, const DrawingChoice&) = default;
};
} // namespace ui
