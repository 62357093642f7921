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

/// Changes the whole model of a document, as one step. The change is worked out on a copy in another thread; meanwhile
/// strokes are refused and requests wait, so that the mesh stays the one that was copied. Thread: gui.
class ModelChanger : public QObject
{
    Q_OBJECT

public:
    explicit ModelChanger(Document* document) : m_document(document) {}

    /// The model as it was opened, for core::Reset.
    const std::shared_ptr<const core::Snapshot>& start() const { return m_start; }
    void setStart(std::shared_ptr<const core::Snapshot> start) { m_start = std::move(start); }

public Q_SLOTS:
    /// A core::Reset needs no start.
    void apply(const core::ModelCommand& command);
    void insert(const ui::InsertRequest& insertion);

Q_SIGNALS:
    /// The model to be inserted is not sound: insert() with InsertRequest::repair may take it.
    void insertionRepairable(const ui::InsertRequest& insertion, const QString& problem);
    /// What was done to the inserted model, step by step.
    void insertedRepaired(const QString& name, const QStringList& steps);

private:
    void start(ModelChangeRequest request);
    void finish(const ModelChangeRequest& request, ModelChangeOutcome outcome);
    void end(const ModelChangeRequest& request, const ModelChangeOutcome& outcome);
    void reportOutcome(const ModelChangeRequest& request, const ModelChangeOutcome& outcome);

    Document* m_document;
    std::shared_ptr<const core::Snapshot> m_start;
};
} // namespace app
