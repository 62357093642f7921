#pragma once

#include "core/operations/model_command.h"

#include <functional>

namespace ui
{
class Actions;
class BrushSettings;
class CurveDrawing;
class Viewport;

/// Connects the actions of the menu Area in the View. Each lets the user draw an area over the view, and then calls
/// `request` with what happens to it, mirrored as the brush's strokes are. Returns the drawing, which the viewport
/// owns. Precondition: all arguments outlive the actions. Thread: gui.
CurveDrawing* connectAreas(const Actions& actions, Viewport* viewport, const BrushSettings* brush,
                           const std::function<void(const core::ModelCommand&)>& request);
} // namespace ui
