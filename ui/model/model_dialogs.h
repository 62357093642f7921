#pragma once

#include "ui/model/insert_request.h"
#include "ui/settings/model_info.h"

#include "core/operations/model_command.h"

#include <functional>

class QWidget;

namespace ui
{
/// Type of the callbacks of the dialogs below, which ask for the parameters of a command on the whole model. Each
/// function returns at once; the callback is called only if the user accepts.
using CommandCallback = std::function<void(const core::ModelCommand& command)>;

void askForScale(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);
void askForMirror(QWidget* parent, const CommandCallback& callback);
void askForSymmetry(QWidget* parent, const CommandCallback& callback);
void askForRemesh(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);
void askForBase(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);

/// Asks for the place and the unit of a model to insert.
void askForPlace(QWidget* parent, const QString& path,
                 const std::function<void(const InsertRequest& insertion)>& callback);
} // namespace ui
