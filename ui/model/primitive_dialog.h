#pragma once

#include "ui/model/model_dialogs.h"

namespace ui
{
/// Asks for a primitive with its measures, its place, and how it is combined with the model. Returns at once;
/// `callback` gets a core::Insert if the user accepts. Measures that are not possible cannot be accepted.
void askForPrimitive(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);
} // namespace ui
