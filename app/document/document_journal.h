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

/// Records the document's changes, so that they survive the program. Thread: gui; nobody waits for the disk.
class DocumentJournal : public QObject
{
    Q_OBJECT

public:
    explicit DocumentJournal(Document* document) : m_document(document) {}

    /// Models opened from now on are recorded there. The store must outlive the document.
    void setRecoveryStore(RecoveryStore* recoveryStore);
    RecoveryStore* recoveryStore() const { return m_recoveryStore; } ///< may be null
    /// The journal of the present model. Null: nothing is recorded.
    const std::shared_ptr<core::Journal>& journal() const { return m_journal; }

    /// Gives the worker the model, with its journal. The journal of the model before is discarded once nobody writes to
    /// it.
    void begin(LoadedModel& model);
    /// The model is installed: if it was recovered, restores its history.
    void restore();
    /// Name, path or notes changed.
    void describe();
    /// The steps before the present are lost.
    void forget();

private:
    void retryRecording();
    void startRecording(const std::shared_ptr<core::JournalFolder>& folder);
    core::JournalDocument document() const;
    core::JournalHistory history() const;

    Document* m_document;
    RecoveryStore* m_recoveryStore = nullptr;
    std::shared_ptr<core::Journal> m_journal;
    std::shared_ptr<core::RecoveredDocument> m_recovered; ///< of the model that is being installed
};
} // namespace app
