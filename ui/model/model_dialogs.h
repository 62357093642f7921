#pragma once

#include "ui/model/insert_request.h"
#include "ui/settings/model_info.h"

#include "core/operations/model_command.h"

#include <functional>

class QWidget;

namespace ui
{
/// The dialogs for what may be done with the whole model. They return at once; the callback is called when the person
/// agreed, and never else.
using CommandCallback = std::function<void(const core::ModelCommand& command)>;

void askForMove(QWidget* parent, const CommandCallback& callback);
void askForRotation(QWidget* parent, const CommandCallback& callback);
void askForScale(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);
void askForMirror(QWidget* parent, const CommandCallback& callback);
void askForSymmetry(QWidget* parent, const CommandCallback& callback);
void askForRemesh(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);
void askForBase(QWidget* parent, const ModelInfo& modelInfo, const CommandCallback& callback);

/// Where the model of a file goes, and how large it is.
void askForPlace(QWidget* parent, const QString& path,
                 const std::function<void(const InsertRequest& insertion)>& callback);
} // namespace ui
