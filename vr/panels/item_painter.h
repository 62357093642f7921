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
    double held = 0; ///< of the time that it must be held, 0 to 1
};

/// Within the item's area. The painter's unit is the dmm.
void paintItem(QPainter& painter, const PanelItem& item, const ItemState& state);
} // namespace vr
