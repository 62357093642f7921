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
/// A request to change the whole model.
struct ModelChangeRequest
{
    core::ModelCommand command;
    /// used only if `command` is a core::Insert without a primitive: the file that the inserted model is read from
    ui::InsertRequest insertion;
    core::PartId part = 0;  ///< the part that the command changes
    bool isPreview = false; ///< whether the user sees the result before it becomes a step
};

/// Result of a change of the whole model.
struct ModelChangeOutcome
{
    core::ModelChange change;
    QString problem; ///< reason why the change was not made, one sentence; empty if there was none
    /// true: the model to insert is not sound, and repairing it (InsertRequest::repair) may help
    bool isRepairable = false;
    QString notice;      ///< message for the user about a change that was made; may be empty
    QStringList repairs; ///< repairs made to the inserted model, one sentence each; empty: none
    /// set if repairing changed the model too much: it was not inserted, and the user must decide
    std::optional<ui::RepairDoubt> doubt;
};

/// Applies a change of the whole model to a copy. Thread: any.
class ModelChangeJob
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelChangeJob)

public:
    /// Returns a copy of the mesh; null if there is not enough memory.
    static std::shared_ptr<core::Mesh> copyOf(const core::Mesh& mesh);
    /// A callback that gets the name of each stage at its beginning.
    using OnStage = std::function<void(const QString& what)>;
    /// Applies the request to the copy, which is consumed. For a core::Insert without a
    /// primitive, reads the model from its file first.
    static ModelChangeOutcome run(const std::shared_ptr<core::Mesh>& copy, ModelChangeRequest request,
                                  const OnStage& onStage, const core::JobControl& control);

private:
    static void read(ModelChangeOutcome& outcome, ModelChangeRequest& request, const OnStage& onStage,
                     const core::JobControl& control);
};
} // namespace app
