#pragma once

#include "ui/settings/view_appearance.h"

namespace ui
{
enum class DrawnSides { All, Front, Right, Top };

inline constexpr std::array<Named<DrawnSides>, 4> drawnSides{
    {{DrawnSides::All, "0"}, {DrawnSides::Front, "1"}, {DrawnSides::Right, "2"}, {DrawnSides::Top, "3"}}};

struct DrawingSettings
{
    DrawnSides sides = DrawnSides::All;
    bool shaded = false; ///< fills the views with colours under the lines
    bool dimensions = true;
    friend bool operator==(const DrawingSettings&, const DrawingSettings&) = default;
};
} // namespace ui
