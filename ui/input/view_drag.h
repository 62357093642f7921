#pragma once

#include "ui/settings/preferences.h"

#include <Qt>

namespace ui
{
/// Effects of a drag.
enum class Drag { None, Stroke, Orbit, Pan, Zoom };

/// Returns how a press moves the view regardless of what it hits. None: the press does not move the view, or its hit
/// decides.
Drag viewDrag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const InputPreferences& preferences);

/// Returns the effect of a left drag beside the model. Precondition: viewDrag() returns None for the press.
Drag dragBesideModel(Qt::KeyboardModifiers modifiers, const InputPreferences& preferences);
} // namespace ui
