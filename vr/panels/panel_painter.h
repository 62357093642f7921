#pragma once

#include "vr/panels/panel_layout.h"

namespace vr
{
/// The state of a wand at an item of a panel.
struct PanelTouch
{
    PanelAction item; ///< action of the item; for a slider, a Slide with any value
    bool isPressed = false;
    double held = 0; ///< fraction of holdSeconds for which the item has been held, 0 to 1

    bool operator==(const PanelTouch&) const = default;
};

/// The touches of both wands, indexed by Side; none: the wand is at no item of the panel.
using PanelTouches = std::array<std::optional<PanelTouch>, sideCount>;

/// Pixels per dmm, about as many as the best headsets have.
inline constexpr double panelSharpness = 1.2;

/// Returns the picture of a panel, with premultiplied alpha and transparent corners. Thread: any. Cost: some
/// milliseconds.
QImage paint(const PanelLayout& layout, const PanelTouches& touches = {}, double pixelsPerDmm = panelSharpness);
} // namespace vr
