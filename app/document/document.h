#pragma once

#include "app/document/document_history.h"
#include "app/document/document_journal.h"
#include "app/document/document_parts.h"
#include "app/document/document_queue.h"
#include "app/document/document_strokes.h"
#include "app/document/last_stroke.h"
#include "app/document/model_changer.h"
#include "app/document/model_opener.h"
#include "app/document/model_saver.h"
#include "app/document/saved_state.h"
#include "app/document/work_timer.h"
#include "app/worker/background_job.h"

#include "core/io/stroke/stroke_file.h"
#include "ui/model/repair_doubt.h"
#include "ui/settings/model_info.h"

namespace app
{
struct MeshFacts;

/// The open model: its name, facts and metadata. Each kind of work on it is done by one of its parts. A change is added
/// to the undo stack once it is done and recorded, so that it would survive a crash. Thread: gui; long work is done on
/// other threads.
class Document : public QObject
{
    Q_OBJECT

public:
    /// The worker is not owned and must outlive the document.
    explicit Document(SculptWorker* worker, QObject* parent = nullptr);
    /// Stops the worker, because its jobs refer to the document.
    ~Document() override;

    SculptWorker& worker() const { return *m_worker; }
    DocumentQueue& queue() { return m_queue; }
    DocumentHistory& history() { return m_history; }
    SavedState& savedState() { return m_savedState; }
    DocumentJournal& journaling() { return m_journaling; }
    LastStroke& lastStroke() { return m_lastStroke; }
    DocumentStrokes& strokes() { return m_strokes; }
    DocumentParts& parts() { return m_parts; }
    ModelChanger& changer() { return m_changer; }
    ModelOpener& opener() { return m_opener; }
    ModelSaver& saver() { return m_saver; }
    /// Returns the long job of the document. Code outside of the document may use it, too.
    BackgroundJob& job() { return m_job; }

    const ui::ModelInfo& modelInfo() const { return m_modelInfo; }
    /// Returns the metadata for a file written now.
    core::DocumentMetadata metadata() const;
    /// Sets a callback that adds metadata from outside of the document whenever a file is written.
    void setCompleteMetadata(std::function<void(core::DocumentMetadata&)> complete);

    // Used by the document's parts.
    void setModel(const LoadedModel& model);
    void takeFacts(const MeshFacts& facts);
    void setFile(const QString& path);
    /// Counts a finished stroke in the metadata.
    void countStroke();
    void notifyStateChanged();

public Q_SLOTS:
    /// Sets the palette that is saved with the document. Does not mark the document as modified.
    void setPalette(std::vector<core::Rgb> palette);
    /// Sets the path after the document's file was renamed.
    void setPath(const QString& path);
    /// Sets the name of a document that has no file.
    void setName(const QString& name);
    /// Cancels the long job, and forgets the model to be opened after it. The present model does not change.
    void cancelJob();

Q_SIGNALS:
    void opened(const ui::ModelInfo& info);
    void modelInfoChanged(const ui::ModelInfo& info);
    void historyChanged();
    /// Emitted when the user has made a step, now the last one of the history. Not emitted for undo and redo.
    void stepped(const core::FileEntry& entry);
    void refused(const QString& sentence);
    void noticed(const QString& sentence);
    /// Emitted if repairing changed a model to be opened or inserted too much. accept() uses the repaired model.
    void repairDoubted(const ui::RepairDoubt& doubt, const std::function<void()>& accept);

private:
    void loseHistory();

    SculptWorker* m_worker;
    ui::ModelInfo m_modelInfo;
    std::function<void(core::DocumentMetadata&)> m_completeMetadata;
    WorkTimer m_workTimer;
    DocumentQueue m_queue;
    DocumentHistory m_history;
    SavedState m_savedState;
    DocumentJournal m_journaling;
    LastStroke m_lastStroke;
    DocumentStrokes m_strokes;
    DocumentParts m_parts;
    ModelChanger m_changer;
    ModelOpener m_opener;
    ModelSaver m_saver;
    BackgroundJob m_job; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
