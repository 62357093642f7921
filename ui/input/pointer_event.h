#pragma once

#include "ui/scene/orbit_camera.h"

#include <Qt>

namespace ui
{
/// A reading of mouse or pen. Nobody asks later which it was.
struct PointerEvent
{
    enum class Kind { Press, Move, Release };

    Kind kind = Kind::Move;
    OrbitCamera::Pixel pixel{0, 0};
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    double time = 0; ///< seconds
    double pressure = 1;
    bool isEraser = false; ///< a pen's other end: it does the opposite
};
} // namespace ui
