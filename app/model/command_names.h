#pragma once

#include "core/operations/model_command.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Translated names and messages for whole-model commands.
class CommandNames
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandNames)

public:
    /// Returns the name of the command's undo step.
    static QString name(const core::ModelCommand& command);
    /// Returns the name of a step that shows or hides one part.
    static QString switching(bool shows);
    /// Returns the name of the command's icon in resources/icons.
    static QString icon(const core::ModelCommand& command);
    /// Returns a phrase that names the command while it is running, e.g. "Moving the model".
    static QString progress(const core::ModelCommand& command);
    /// Returns one sentence that says what was not done and why; empty if the change was not refused. `inserted`: path
    /// of the file whose model was to be inserted; empty for a primitive.
    static QString refusal(const core::ModelChange& change, const QString& inserted);
    /// Returns why a primitive cannot be made, one sentence; empty if it can.
    static QString problem(const core::PrimitiveResult& primitive);
    /// Returns the message for a command that changed nothing.
    static QString unchanged(const core::ModelCommand& command);
    /// Returns the message for a command that shortens a name; empty for others.
    static QString shortening(const core::ModelCommand& command);
};
} // namespace app
