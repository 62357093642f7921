#pragma once

#include "vr/panels/panel_layout.h"

namespace vr
{
/// What a wand does at an item.
struct PanelTouch
{
    PanelAction item; ///< any action of it
    bool isPressed = false;
    double held = 0; ///< the share of the time that it must be held, 0 to 1

    bool operator==(const PanelTouch&) const = default;
};

/// By Side.
using PanelTouches = std::array<std::optional<PanelTouch>, sideCount>;

/// So many pixels to a dmm are about as many as the best headsets have.
inline constexpr double panelSharpness = 1.2;

/// The panel, premultiplied, with transparent corners. Any thread; takes some milliseconds.
QImage paint(const PanelLayout& layout, const PanelTouches& touches = {}, double pixelsPerDmm = panelSharpness);
} // namespace vr
