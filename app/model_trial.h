#pragma once

#include "core/model_command.h"

#include <QCoreApplication>
#include <QString>

#include <memory>

namespace app
{
/// What became of a change of the whole model.
struct ModelOutcome
{
    core::ModelChange change;
    QString problem; ///< it was not done: one sentence
};

/// Works a change of the whole model out on a copy. Any thread.
class ModelTrial
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelTrial)

public:
    /// Null: there is not enough memory.
    static std::shared_ptr<core::Mesh> copyOf(const core::Mesh& mesh);
    /// Uses the copy up. What is to be inserted is read from `insertedPath` first.
    static ModelOutcome run(const std::shared_ptr<core::Mesh>& copy, core::ModelCommand& command, const QString& insertedPath,
                            const core::JobWatch& watch);
};
} // namespace app
