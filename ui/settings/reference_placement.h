#pragma once

#include "ui/settings/view_appearance.h"

#include <array>

namespace ui
{
/// Position of the camera: Front at +Z, Right at +X, Top at +Y. Front and Top have +X to the right.
enum class ViewSide { Front, Back, Right, Left, Top, Bottom };

inline constexpr double minReferenceWidth = 0.01, maxReferenceWidth = 100000, maxReferenceOffset = 100000;
inline constexpr double minReferenceOpacity = 0.05, defaultReferenceOpacity = 0.6;

inline constexpr std::array<Named<ViewSide>, 6> viewSides{{{ViewSide::Front, "front"},
                                                           {ViewSide::Back, "back"},
                                                           {ViewSide::Right, "right"},
                                                           {ViewSide::Left, "left"},
                                                           {ViewSide::Top, "top"},
                                                           {ViewSide::Bottom, "bottom"}}};

/// Placement of a reference image in the view from its side. Lengths in mm.
struct ReferencePlacement
{
    double width = 100;
    double x = 0, y = 0; ///< centre of the image, mm to the right of and above the origin
    double opacity = defaultReferenceOpacity;
    bool inFront = false; ///< draws the image over the model instead of behind it

    bool operator==(const ReferencePlacement&) const = default;
};
} // namespace ui
