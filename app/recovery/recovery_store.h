#pragma once

#include "core/journal/journal.h"
#include "ui/util/background_thread.h"
#include "ui/util/thread_mailbox.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <mutex>

namespace app
{
struct LoadedModel;

/// A document that was not saved when the program ended, and can be recovered.
struct RecoveryOffer
{
    quint64 id = 0; ///< 0: none
    QString name;
    QDateTime changed;
    int steps = 0; ///< number of steps in effect (not undone)
};

/// The journals of this program, and those that earlier runs left behind. The destructor removes the journals of this
/// program's documents, because a regular end means that the user has saved or discarded them. If the program ends by
/// exit() instead, because the display is gone, the journals are kept and a message on stderr says so. Precondition:
/// one object at a time. Thread: gui, unless a function says otherwise.
/// A failure to record is reported once, by noticed(). Recording is then retried by retryDue(), findSpace(),
/// spaceFound() and beginDeferred().
class RecoveryStore : public QObject
{
    Q_OBJECT

public:
    /// Returns the folder for journals, in the user's state folder.
    static std::filesystem::path defaultRoot();

    explicit RecoveryStore(std::filesystem::path root = defaultRoot(), core::JournalLimits limits = {});
    ~RecoveryStore() override;

    /// Sets the interval before the first retry of a failure; each further failure doubles it, up to 5 minutes.
    void setRetryInterval(std::chrono::milliseconds interval);

    /// Begins the journal of a model that is about to be opened. Returns null if that is impossible. Thread: any. Cost:
    /// writing the model.
    std::shared_ptr<core::Journal> begin(const LoadedModel& model);
    /// Removes a journal that is no longer needed, in the background. `journal` may be null. Precondition: nobody
    /// writes to the journal. Thread: any.
    void discard(std::shared_ptr<core::Journal> journal);

    /// Sets the journal of the document that is open. Null: nothing is recorded.
    void setPresent(std::shared_ptr<core::Journal> journal);
    /// Looks for disk space for the journal of a model with `faces` faces. Emits spaceFound(), or retryDue() after the
    /// retry interval.
    void findSpace(quint64 faces);
    /// Begins a journal that replaces the present one. The present journal is removed once the new one is written.
    /// `present`: number of steps in effect.
    std::shared_ptr<core::Journal> beginDeferred(const std::shared_ptr<core::JournalFolder>& folder, quint32 present);

    /// Looks for journals that earlier runs left, in the background. Emits offered(), and noticed() for damaged ones.
    void findAbandoned();
    /// Returns a recovered model with its history. It has no sculptor if recovery failed or was cancelled. Thread: any.
    /// Cost: reading and applying the whole journal.
    LoadedModel recover(quint64 offer, const core::JobControl& control);
    /// Resumes the journal of a recovered document that is open again, and withdraws the offer. Returns null if the
    /// journal is damaged; it is then set aside once a new journal has begun.
    std::shared_ptr<core::Journal> resume(quint64 offer, const core::RecoveredDocument& document);
    /// Removes the journal of an offer that the user does not want.
    void discard(quint64 offer);

Q_SIGNALS:
    /// Emitted with the latest document that can be recovered; id 0: none is left.
    void offered(const app::RecoveryOffer& offer);
    /// Emitted with a message for the user: changes are not recorded, are recorded again, or are recorded late; or a
    /// journal of an earlier run is damaged.
    void noticed(const QString& sentence);
    /// Emitted when recording of the present document has failed and it is time to retry.
    void retryDue();
    /// Emitted with a folder on a disk that has the space requested by findSpace().
    void spaceFound(const std::shared_ptr<core::JournalFolder>& folder);

private:
    struct AbandonedJournal
    {
        RecoveryOffer offer;
        std::unique_ptr<core::JournalFolder> folder;
    };
    struct ScanResult
    {
        std::vector<AbandonedJournal> abandoned;
        QStringList notices;
    };

    static void atExit();
    static std::filesystem::path damagedRoot(const std::filesystem::path& root);
    static ScanResult scan(const std::filesystem::path& root);
    static QString putAside(core::JournalFolder& folder, const QString& name, const std::filesystem::path& root);
    core::JournalCallbacks callbacks();
    void reportFailure(const core::FileError& error);
    void reportLate(double ms);
    void reportRecording();
    void onJournalBegun();
    AbandonedJournal takeAbandoned(quint64 offer);
    void offerNext();

    static RecoveryStore* s_present;
    const std::filesystem::path m_root;
    const core::JournalLimits m_limits;
    std::mutex m_mutex; ///< guards m_open and m_abandoned
    std::vector<std::shared_ptr<core::Journal>> m_open;
    std::vector<AbandonedJournal> m_abandoned;
    std::shared_ptr<core::Journal> m_journal; ///< journal of the present document; null: nothing is recorded
    /// Broken journals that m_journal replaces. Only they contain the document until m_journal is written.
    std::vector<std::shared_ptr<core::Journal>> m_superseded;
    /// Damaged journals that were partly recovered. They are set aside once m_journal is written.
    std::vector<std::shared_ptr<core::JournalFolder>> m_damaged;
    std::chrono::milliseconds m_retryInterval, m_nextRetryInterval;
    QTimer m_retryTimer;
    bool m_isFailing = false, m_hasBeenLate = false;
    ui::ThreadMailbox m_mailbox;
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
