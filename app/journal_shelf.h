#pragma once

#include "core/journal/journal.h"
#include "ui/mailbox.h"
#include "ui/side_thread.h"

#include <QDateTime>
#include <QObject>

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

/// The journals of this program, and those that programs before left. Gui thread, but where it says otherwise. As it goes, the
/// journals of its documents go: the program has ended as the person wished. If it ends by exit() instead, because the display is
/// gone, they stay, and stderr says so. One at a time.
class JournalShelf : public QObject
{
    Q_OBJECT

public:
    /// Under the user's state folder.
    static std::filesystem::path usualRoot();

    explicit JournalShelf(std::filesystem::path root = usualRoot(), core::JournalLimits limits = {});
    ~JournalShelf() override;

    /// Of a model that is about to be opened. Null if that is impossible; said once. Any thread.
    std::shared_ptr<core::Journal> begin(const LoadedModel& model);
    /// What it holds is of no use any more, and nobody writes to it. Null is none. Any thread.
    void discard(std::shared_ptr<core::Journal> journal);

    /// Looks for what was left; offered() comes when something is found.
    void look();
    /// A model with its history. Any thread; takes reading and applying all. Without a sculptor if that is impossible, or it was stopped.
    LoadedModel recover(quint64 offer, const core::JobWatch& watch);
    /// The document is open again; the offer is gone.
    std::shared_ptr<core::Journal> goOn(quint64 offer, const core::RecoveredDocument& document);
    /// It is not wanted: it is removed, and never offered again.
    void discard(quint64 offer);

Q_SIGNALS:
    /// The latest that there is; id 0: none, any more.
    void offered(const app::RecoveryOffer& offer);
    /// Changes are not recorded any more. Once.
    void failed(const QString& sentence);

private:
    struct Left
    {
        RecoveryOffer offer;
        std::unique_ptr<core::JournalFolder> folder;
    };

    static void atExit();
    static std::vector<Left> leftIn(const std::filesystem::path& root);
    core::JournalWriter::Broken teller();
    void tellFailure(const core::FileError& error);
    Left take(quint64 offer);
    void offerNext();

    static JournalShelf* s_present;
    const std::filesystem::path m_root;
    const core::JournalLimits m_limits;
    std::mutex m_mutex; ///< guards the next two
    std::vector<std::shared_ptr<core::Journal>> m_open;
    std::vector<Left> m_left;
    bool m_hasFailed = false;
    ui::Mailbox m_mail;
    ui::SideThread m_aside; ///< last
};
} // namespace app
