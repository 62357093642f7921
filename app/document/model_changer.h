#pragma once

#include "core/operations/model_command.h"
#include "ui/model/insert_request.h"

#include <QObject>

#include <memory>

namespace app
{
class Document;
struct ModelChangeRequest;
struct ModelChangeOutcome;

/// Changes the whole model of a document as one step. The change is computed on a copy in another thread. Strokes are
/// refused and requests wait meanwhile, so that the mesh stays equal to the copy. Thread: gui.
class ModelChanger : public QObject
{
    Q_OBJECT

public:
    explicit ModelChanger(Document* document) : m_document(document) {}

    /// Returns the model as it was opened, for core::Reset.
    const std::shared_ptr<const core::Snapshot>& start() const { return m_start; }
    void setStart(std::shared_ptr<const core::Snapshot> start) { m_start = std::move(start); }

public Q_SLOTS:
    /// Applies a command to the active part, or to the parts that it concerns (core::applyToCopy()). The `start` of a
    /// core::Reset is filled in.
    void apply(const core::ModelCommand& command);
    void applyTo(core::PartId part, const core::ModelCommand& command);
    void insert(const ui::InsertRequest& insertion);

Q_SIGNALS:
    /// Emitted if the model to insert is not sound. insert() with InsertRequest::repair may succeed.
    void insertionRepairable(const ui::InsertRequest& insertion, const QString& problem);
    /// Emitted at the end of each request, also of one that another long job has prevented. `isMade`: it has become a
    /// step.
    void ended(bool isMade);
    /// Emitted with the repairs made to the inserted model, one sentence each.
    void insertedRepaired(const QString& name, const QStringList& steps);

private:
    void start(ModelChangeRequest request);
    void applyInFrame(const ModelChangeRequest& request);
    void finish(const ModelChangeRequest& request, ModelChangeOutcome outcome);
    void end(const ModelChangeRequest& request, const ModelChangeOutcome& outcome);
    void reportOutcome(const ModelChangeRequest& request, const ModelChangeOutcome& outcome);

    Document* m_document;
    std::shared_ptr<const core::Snapshot> m_start;
};
} // namespace app
