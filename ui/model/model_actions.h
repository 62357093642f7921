#pragma once

#include "ui/settings/model_info.h"

#include "core/operations/model_command.h"

#include <functional>

class QWidget;

namespace ui
{
class Actions;
class BrushSettings;

/// Connects the actions of the Model menu, except Insert. Each action asks for its parameters in a dialog, if it has
/// any, and calls `request`. `modelInfo`: returns data of the present model. Fill and the mask by colour use the
/// brush's colour. Precondition: all arguments outlive the actions. Thread: gui.
void connectModel(const Actions& actions, QWidget* window, const std::function<const ModelInfo&()>& modelInfo,
                  const BrushSettings* brush, const std::function<void(const core::ModelCommand&)>& request);
} // namespace ui
