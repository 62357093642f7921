#pragma once

#include "app/document/document_history.h"
#include "app/document/document_journal.h"
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

/// The model that is open: its name, its facts and its notes. Each kind of work on it is a part of its own. A change
/// comes to the undo stack when it is done and would survive the program. Thread: gui; long work is done on other
/// threads.
class Document : public QObject
{
    Q_OBJECT

public:
    /// The worker is not owned and must outlive the document.
    explicit Document(SculptWorker* worker, QObject* parent = nullptr);
    /// Stops the worker, whose jobs know the document.
    ~Document() override;

    SculptWorker& worker() const { return *m_worker; }
    DocumentQueue& queue() { return m_queue; }
    DocumentHistory& history() { return m_history; }
    SavedState& savedState() { return m_savedState; }
    DocumentJournal& journaling() { return m_journaling; }
    LastStroke& lastStroke() { return m_lastStroke; }
    DocumentStrokes& strokes() { return m_strokes; }
    ModelChanger& changer() { return m_changer; }
    ModelOpener& opener() { return m_opener; }
    ModelSaver& saver() { return m_saver; }
    /// The long job that is going on. Work outside the document may use it, too.
    BackgroundJob& job() { return m_job; }

    const ui::ModelInfo& modelInfo() const { return m_modelInfo; }
    /// Notes for a file that is written now.
    core::DocumentMetadata metadata() const;
    /// Called when a file is about to be written: adds what is known outside the document.
    void setCompleteMetadata(std::function<void(core::DocumentMetadata&)> complete);

    // For the parts.
    void setModel(const LoadedModel& model);
    void takeFacts(const MeshFacts& facts);
    void setFile(const QString& path);
    /// One more stroke has ended.
    void countStroke();
    void notifyStateChanged();

public Q_SLOTS:
    /// The palette of its files. Does not modify the document.
    void setPalette(std::vector<core::Rgb> palette);
    /// Its file was renamed.
    void setPath(const QString& path);
    /// Its name while it has no file.
    void setName(const QString& name);
    /// Cancels the long job and what was to be opened after it. The model stays as it is.
    void cancelJob();

Q_SIGNALS:
    void opened(const ui::ModelInfo& info);
    void modelInfoChanged(const ui::ModelInfo& info);
    void historyChanged();
    /// A step was done by hand. It is the last of the history now. Not emitted for undo and redo.
    void stepped(const core::FileEntry& entry);
    void refused(const QString& sentence);
    void noticed(const QString& sentence);
    /// A repair did not keep the model that was to be opened or inserted: accept() takes it all the same.
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
    ModelChanger m_changer;
    ModelOpener m_opener;
    ModelSaver m_saver;
    BackgroundJob m_job; ///< last: its thread uses the others
};
} // namespace app
