#pragma once

#include "vr/panels/panel_layout.h"

class QPainter;

namespace vr
{
struct ItemState
{
    bool isEnabled = true;
    bool isHovered = false;
    bool isPressed = false;
    bool mustHold = false;
    double held = 0; ///< fraction of holdSeconds for which the item has been held, 0 to 1
};

/// Paints an item within its area. The painter's unit is the dmm (panel_layout.h).
void paintItem(QPainter& painter, const PanelItem& item, const ItemState& state);
} // namespace vr
