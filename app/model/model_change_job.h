#pragma once

#include "core/operations/model_command.h"
#include "ui/model/insert_request.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>

namespace app
{
/// What became of a change of the whole model.
struct ModelOutcome
{
    core::ModelChange change;
    QString problem;         ///< it was not done: one sentence
    bool isMendable = false; ///< then: the model to be inserted is not in order; ui::InsertRequest::repair may help
    QString notice;          ///< what the person should know of an inserted model; may be empty
    QStringList mended;      ///< what was done to it; empty: nothing
};

/// Works a change of the whole model out on a copy. Any thread.
class ModelTrial
{
    Q_DECLARE_TR_FUNCTIONS(app::ModelTrial)

public:
    /// Null: there is not enough memory.
    static std::shared_ptr<core::Mesh> copyOf(const core::Mesh& mesh);
    /// What is going on, while it does.
    using Tell = std::function<void(const QString& what)>;
    /// Uses the copy up. What is to be inserted is read first.
    static ModelOutcome run(const std::shared_ptr<core::Mesh>& copy, core::ModelCommand& command,
                            const ui::InsertRequest& insertion, const Tell& tell, const core::JobControl& control);

private:
    static void read(ModelOutcome& outcome, core::Insert& command, const ui::InsertRequest& insertion, const Tell& tell,
                     const core::JobControl& control);
};
} // namespace app
