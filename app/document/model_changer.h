#pragma once

#include "core/mesh/draw_arrays.h"
#include "core/operations/model_command.h"
#include "ui/model/insert_request.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>

#include <memory>

namespace app
{
class Document;
struct ModelChangeRequest;
struct ModelChangeOutcome;

/// Changes the whole model of a document as one step. The change is computed on a copy in another thread. Strokes are
/// refused and requests wait meanwhile, so that the mesh stays equal to the copy. They also wait during a preview: the
/// mesh then is the result, which the journal does not know yet. Thread: gui.
class ModelChanger : public QObject
{
    Q_OBJECT

public:
    explicit ModelChanger(Document* document) : m_document(document) {}

    /// Returns whether a preview is shown or being computed.
    bool isPreviewing() const { return m_isPreviewing; }

    /// Returns the model as it was opened, for core::Reset.
    const std::shared_ptr<const core::Snapshot>& start() const { return m_start; }
    void setStart(std::shared_ptr<const core::Snapshot> start) { m_start = std::move(start); }

public Q_SLOTS:
    /// Applies a command to the active part, or to the parts that it concerns (core::applyToCopy()). The `start` of a
    /// core::Reset is filled in.
    void apply(const core::ModelCommand& command);
    void applyTo(core::PartId part, const core::ModelCommand& command);
    void insert(const ui::InsertRequest& insertion);
    /// Shows the result of combining a part with others. It becomes a step by applyPreview(), and dropPreview() takes
    /// it back. Emits previewed(), or previewEnded() if there is no result.
    void preview(core::PartId part, const core::CombineParts& command);
    /// Shows the result of another operation on the parts of the preview instead.
    void previewInstead(core::SetOperation operation);
    void applyPreview();
    /// Ends the preview, also one that is being computed. Has no effect if there is none.
    void dropPreview();

Q_SIGNALS:
    /// `translucent`: the parts that the operation has taken away, mm.
    void previewed(core::SetOperation operation, const std::shared_ptr<const core::DrawArrays>& translucent);
    /// Another result is being computed in the place of the one that was shown; previewed() or previewEnded() follows.
    void previewTakenBack();
    void previewEnded();
    /// Emitted if the model to insert is not sound. insert() with InsertRequest::repair may succeed.
    void insertionRepairable(const ui::InsertRequest& insertion, const QString& problem);
    /// Emitted at the end of each request, also of one that another long job has prevented. `isMade`: it has become a
    /// step.
    void ended(bool isMade);
    /// Emitted with the repairs made to the inserted model, one sentence each.
    void insertedRepaired(const QString& name, const QStringList& steps);

private:
    struct Change;

    void start(ModelChangeRequest request);
    void compute(const ModelChangeRequest& request);
    void applyInFrame(const ModelChangeRequest& request);
    void finish(const ModelChangeRequest& request, ModelChangeOutcome outcome);
    void show(const std::shared_ptr<const Change>& change);
    void takeBack();
    void record(const std::shared_ptr<const Change>& change);
    void end(const ModelChangeRequest& request, const ModelChangeOutcome& outcome);
    void reportOutcome(const ModelChangeRequest& request, const ModelChangeOutcome& outcome);

    Document* m_document;
    std::shared_ptr<const core::Snapshot> m_start;
    std::shared_ptr<const Change> m_preview; ///< the change that is in the mesh and not yet a step; null: none
    bool m_isPreviewing = false;             ///< from the beginning of the computation until previewEnded()
    ui::ThreadMailbox m_mailbox;
};
} // namespace app
