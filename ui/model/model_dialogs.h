#pragma once

#include "ui/model/insert_request.h"
#include "ui/settings/model_info.h"

#include "core/operations/model_command.h"

#include <functional>

class QWidget;

namespace ui
{
/// The dialogs for what may be done with the whole model. They return at once; the answer is called when the person
/// agreed, and never else.
using CommandAnswer = std::function<void(const core::ModelCommand& command)>;

void askForMove(QWidget* parent, const CommandAnswer& answer);
void askForRotation(QWidget* parent, const CommandAnswer& answer);
void askForScale(QWidget* parent, const ModelFacts& facts, const CommandAnswer& answer);
void askForMirror(QWidget* parent, const CommandAnswer& answer);
void askForSymmetry(QWidget* parent, const CommandAnswer& answer);
void askForRemesh(QWidget* parent, const ModelFacts& facts, const CommandAnswer& answer);
void askForBase(QWidget* parent, const ModelFacts& facts, const CommandAnswer& answer);

/// Where the model of a file goes, and how large it is.
void askForPlace(QWidget* parent, const QString& path, const std::function<void(const Insertion& insertion)>& answer);
} // namespace ui
