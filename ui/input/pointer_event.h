#pragma once

#include "ui/scene/orbit_camera.h"

#include <Qt>

namespace ui
{
/// An event of mouse, pen or finger in a common form.
struct PointerEvent
{
    enum class Kind { Press, Move, Release };

    Kind kind = Kind::Move;
    OrbitCamera::Pixel pixel{0, 0};
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    double time = 0; ///< seconds
    double pressure = 1;
    bool isEraser = false; ///< eraser end of a pen, which inverts the tool
};
} // namespace ui
