#pragma once

#include "ui/settings/model_info.h"

#include "core/operations/model_command.h"

#include <functional>

class QWidget;

namespace ui
{
class Actions;
class BrushSettings;

/// The actions of the Model menu but Insert: each asks for its numbers in a dialog of the window, if it has any, and
/// requests the command. `modelInfo`: of the model as it is then. Fill and the mask by colour take the brush's. All
/// must outlive the actions. Thread: gui.
void connectModel(const Actions& actions, QWidget* window, const std::function<const ModelInfo&()>& modelInfo,
                  const BrushSettings* brush, const std::function<void(const core::ModelCommand&)>& request);
} // namespace ui
