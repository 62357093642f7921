#pragma once

#include <QObject>

#include <memory>

namespace core
{
class Journal;
class JournalFolder;
struct JournalDocument;
struct JournalHistory;
struct RecoveredDocument;
} // namespace core

namespace app
{
class Document;
class RecoveryStore;
struct LoadedModel;

/// Records the document's changes so that they survive a crash. Thread: gui; no function waits for the disk.
class DocumentJournal : public QObject
{
    Q_OBJECT

public:
    explicit DocumentJournal(Document* document) : m_document(document) {}

    /// Sets the store that records models opened from now on. It must outlive the document.
    void setRecoveryStore(RecoveryStore* recoveryStore);
    RecoveryStore* recoveryStore() const { return m_recoveryStore; } ///< may be null
    /// Returns the journal of the present model; null: nothing is recorded.
    const std::shared_ptr<core::Journal>& journal() const { return m_journal; }

    /// Gives the model and its journal to the worker. The previous model's journal is discarded once nothing is written
    /// to it.
    void begin(LoadedModel& model);
    /// Restores the history of a recovered model. Called when the model is installed.
    void restore();
    /// Records the changed name, path or metadata.
    void describe();
    /// Records that the steps before the present one are lost.
    void forget();

private:
    void retryRecording();
    void startRecording(const std::shared_ptr<core::JournalFolder>& folder);
    core::JournalDocument document() const;
    core::JournalHistory history() const;

    Document* m_document;
    RecoveryStore* m_recoveryStore = nullptr;
    std::shared_ptr<core::Journal> m_journal;
    std::shared_ptr<core::RecoveredDocument> m_recovered; ///< data of the recovered model that is being installed
};
} // namespace app
