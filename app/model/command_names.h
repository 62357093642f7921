#pragma once

#include "core/operations/model_command.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Whole-model commands in words.
class CommandNames
{
    Q_DECLARE_TR_FUNCTIONS(app::CommandNames)

public:
    /// The undo step.
    static QString name(const core::ModelCommand& command);
    /// Of those in resources/icons.
    static QString icon(const core::ModelCommand& command);
    /// The name of the command while it runs.
    static QString progress(const core::ModelCommand& command);
    /// What was not done, where and why: one sentence. `inserted`: the file of the inserted model.
    static QString refusal(const core::ModelChange& change, const QString& inserted);
    /// The notice if the command changed nothing.
    static QString unchanged(const core::ModelCommand& command);
};
} // namespace app
