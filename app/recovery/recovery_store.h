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

/// The journals of this program, and those that programs before left. Gui thread, but where it says otherwise. As it
/// goes, the journals of its documents go: the program has ended as the person wished. If it ends by exit() instead,
/// because the display is gone, they stay, and stderr says so. One at a time.
///
/// Where nothing can be recorded, this is said once, and tried again from time to time: mayRecord(), findRoom(),
/// roomFound(), beginDeferred().
class JournalShelf : public QObject
{
    Q_OBJECT

public:
    /// Under the user's state folder.
    static std::filesystem::path usualRoot();

    explicit JournalShelf(std::filesystem::path root = usualRoot(), core::JournalLimits limits = {});
    ~JournalShelf() override;

    /// How long it waits before it tries again what failed; longer, each time that it fails again.
    void setPatience(std::chrono::milliseconds patience);

    /// Of a model that is about to be opened. Null if that is impossible. Any thread.
    std::shared_ptr<core::Journal> begin(const LoadedModel& model);
    /// What it holds is of no use any more, and nobody writes to it. Null is none. Any thread.
    void discard(std::shared_ptr<core::Journal> journal);

    /// The one of the document that is open. Null: nothing is recorded.
    void setPresent(std::shared_ptr<core::Journal> journal);
    /// For the present of a model with so many faces; roomFound(), or mayRecord() after a while.
    void findRoom(quint64 faces);
    /// In the place of the one that is present, which goes once this has begun.
    std::shared_ptr<core::Journal> beginDeferred(const std::shared_ptr<core::JournalFolder>& folder, quint32 present);

    /// Looks for what was left; offered() comes when something is found.
    void look();
    /// A model with its history. Any thread; takes reading and applying all. Without a sculptor if that is impossible,
    /// or it was stopped.
    LoadedModel recover(quint64 offer, const core::JobControl& control);
    /// The document is open again; the offer is gone. Null if its journal is damaged: then that is put aside once there
    /// is another.
    std::shared_ptr<core::Journal> goOn(quint64 offer, const core::RecoveredDocument& document);
    /// It is not wanted: it is removed, and never offered again.
    void discard(quint64 offer);

Q_SIGNALS:
    /// The latest that there is; id 0: none, any more.
    void offered(const app::RecoveryOffer& offer);
    /// Changes are not recorded any more, or again; late; or what was left is damaged.
    void told(const QString& sentence);
    /// Should nothing be recorded of the document, that may be possible now.
    void mayRecord();
    void roomFound(const std::shared_ptr<core::JournalFolder>& folder);

private:
    struct Left
    {
        RecoveryOffer offer;
        std::unique_ptr<core::JournalFolder> folder;
    };
    struct Found
    {
        std::vector<Left> left;
        QStringList told;
    };

    static void atExit();
    static std::filesystem::path damagedRoot(const std::filesystem::path& root);
    static Found foundIn(const std::filesystem::path& root);
    static QString putAside(core::JournalFolder& folder, const QString& name, const std::filesystem::path& root);
    core::JournalCallbacks news();
    void tellFailure(const core::FileError& error);
    void tellLate(double ms);
    void tellWorks();
    void takeBegun();
    Left take(quint64 offer);
    void offerNext();

    static JournalShelf* s_present;
    const std::filesystem::path m_root;
    const core::JournalLimits m_limits;
    std::mutex m_mutex; ///< guards the next two
    std::vector<std::shared_ptr<core::Journal>> m_open;
    std::vector<Left> m_left;
    std::shared_ptr<core::Journal> m_journal; ///< the present one
    /// Broken ones, which hold what it does not before it has begun.
    std::vector<std::shared_ptr<core::Journal>> m_superseded;
    std::vector<std::shared_ptr<core::JournalFolder>> m_damaged; ///< the same of those that were recovered in part
    std::chrono::milliseconds m_patience, m_wait;
    QTimer m_again;
    bool m_isFailing = false, m_hasBeenLate = false;
    ui::ThreadMailbox m_mail;
    ui::BackgroundThread m_aside; ///< last
};
} // namespace app
