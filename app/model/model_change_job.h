#pragma once

#include "core/operations/model_command.h"
#include "ui/model/insert_request.h"
#include "ui/model/repair_doubt.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>

namespace app
{
/// A change of the whole model.
struct ModelChangeRequest
{
    core::ModelCommand command;
    ui::InsertRequest insertion; ///< with a core::Insert, whose model is read from its file
};

/// What became of a change of the whole model.
struct ModelChangeOutcome
{
    core::ModelChange change;
    QString problem;           ///< it was not done: one sentence
    bool isRepairable = false; ///< then: the model to be inserted is not in order; ui::InsertRequest::repair may help
    QString notice;            ///< what the person should know of an inserted model; may be empty
    QStringList repairs;       ///< what was done to it; empty: nothing
    std::optional<ui::RepairDoubt> doubt; ///< the repairs did not keep it, and it was not inserted
};

/// Applies a change of the whole model to a copy. Thread: any.
class ModelChangeJob
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelChangeJob)

public:
    /// Null: there is not enough memory.
    static std::shared_ptr<core::Mesh> copyOf(const core::Mesh& mesh);
    /// Called at the beginning of each stage with its name.
    using OnStage = std::function<void(const QString& what)>;
    /// Consumes the copy. What is to be inserted is read first.
    static ModelChangeOutcome run(const std::shared_ptr<core::Mesh>& copy, ModelChangeRequest request,
                                  const OnStage& onStage, const core::JobControl& control);

private:
    static void read(ModelChangeOutcome& outcome, ModelChangeRequest& request, const OnStage& onStage,
                     const core::JobControl& control);
};
} // namespace app
