#pragma once

#include "vr/panels/panel_layout.h"

class QPainter;

namespace vr
{
struct PartState
{
    bool isEnabled = true;
    bool isHovered = false;
    bool isPressed = false;
    bool mustHold = false;
    double held = 0; ///< of the time that it must be held, 0 to 1
};

/// Within the part's area. The painter's unit is the dmm.
void paintPart(QPainter& painter, const PanelPart& part, const PartState& state);
} // namespace vr
