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

/// A document that was not saved when the program ended, and may be had again.
struct RecoveryOffer
{
    quint64 id = 0; ///< 0: none
    QString name;
    QDateTime changed;
    int steps = 0; ///< that are done
};

/// The journals of this program, and those that programs before left. Gui thread, but where it says otherwise. Its
/// destructor removes the journals of its documents: the program has ended as the user wished. If it ends by exit()
/// instead, because the display is gone, they stay, and stderr says so. One at a time.
///
/// Where nothing can be recorded, this is said once, and tried again from time to time: retryDue(), findSpace(),
/// spaceFound(), beginDeferred().
class RecoveryStore : public QObject
{
    Q_OBJECT

public:
    /// Under the user's state folder.
    static std::filesystem::path defaultRoot();

    explicit RecoveryStore(std::filesystem::path root = defaultRoot(), core::JournalLimits limits = {});
    ~RecoveryStore() override;

    /// The interval before it retries what failed; longer after each further failure.
    void setRetryInterval(std::chrono::milliseconds interval);

    /// Of a model that is about to be opened. Null if that is impossible. Any thread.
    std::shared_ptr<core::Journal> begin(const LoadedModel& model);
    /// What it holds is of no use any more, and nobody writes to it. Null is none. Any thread.
    void discard(std::shared_ptr<core::Journal> journal);

    /// The one of the document that is open. Null: nothing is recorded.
    void setPresent(std::shared_ptr<core::Journal> journal);
    /// For the present of a model with so many faces; spaceFound(), or retryDue() after a while.
    void findSpace(quint64 faces);
    /// In the place of the one that is present, which goes once this has begun.
    std::shared_ptr<core::Journal> beginDeferred(const std::shared_ptr<core::JournalFolder>& folder, quint32 present);

    /// Looks for what was left; offered() comes when something is found.
    void findAbandoned();
    /// A model with its history. Any thread; takes reading and applying all. Without a sculptor if that is impossible,
    /// or it was stopped.
    LoadedModel recover(quint64 offer, const core::JobControl& control);
    /// The document is open again; the offer is gone. Null if its journal is damaged: then that one is moved away once
    /// there is another.
    std::shared_ptr<core::Journal> resume(quint64 offer, const core::RecoveredDocument& document);
    /// It is not wanted: it is removed, and never offered again.
    void discard(quint64 offer);

Q_SIGNALS:
    /// The latest that there is; id 0: none, any more.
    void offered(const app::RecoveryOffer& offer);
    /// Changes are not recorded any more, or again; late; or what was left is damaged.
    void noticed(const QString& sentence);
    /// Should nothing be recorded of the document, that may be possible now.
    void retryDue();
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
    std::mutex m_mutex; ///< guards the next two
    std::vector<std::shared_ptr<core::Journal>> m_open;
    std::vector<AbandonedJournal> m_abandoned;
    std::shared_ptr<core::Journal> m_journal; ///< the present one
    /// Broken ones, which hold what it does not before it has begun.
    std::vector<std::shared_ptr<core::Journal>> m_superseded;
    std::vector<std::shared_ptr<core::JournalFolder>> m_damaged; ///< the same of those that were recovered in part
    std::chrono::milliseconds m_retryInterval, m_nextRetryInterval;
    QTimer m_retryTimer;
    bool m_isFailing = false, m_hasBeenLate = false;
    ui::ThreadMailbox m_mailbox;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
