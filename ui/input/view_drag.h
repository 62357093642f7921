#pragma once

#include "ui/settings/preferences.h"

#include <Qt>

namespace ui
{
/// What a drag does.
enum class Drag { None, Stroke, Orbit, Pan, Zoom };

/// How a press moves the view, wherever it is; None: it does not, or that depends on what is under it.
Drag viewDrag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const InputPreferences& preferences);

/// What a left press there is, if viewDrag() leaves it to what is under it.
Drag dragBesideModel(Qt::KeyboardModifiers modifiers, const InputPreferences& preferences);
} // namespace ui
