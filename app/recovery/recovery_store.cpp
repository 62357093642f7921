#include "app/recovery/recovery_store.h"

#include "app/model/model_loader.h"

#include "ui/util/error_messages.h"

#include <QDir>
#include <QLocale>
#include <QStandardPaths>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace app
{
namespace
{
void say(const QString& sentence)
{
    std::fprintf(stderr, "fettle: %s\n", qPrintable(sentence));
}

std::string text(const QString& string)
{
    return string.toUtf8().toStdString();
}

constexpr std::chrono::milliseconds defaultRetryInterval = std::chrono::seconds(10),
                                    maxRetryInterval = std::chrono::minutes(5);
constexpr std::uintmax_t bytesPerFace = 128; ///< of a start and a base, with some free slots

/// Null if there is no room, or it may not be.
std::shared_ptr<core::JournalFolder> makeFolderIfRoom(const std::filesystem::path& root, std::uintmax_t bytes)
{
    try {
        std::shared_ptr<core::JournalFolder> folder = core::JournalFolder::makeHidden(root);
        std::error_code problem;
        const auto space = std::filesystem::space(root, problem);
        return !problem && space.available < bytes ? nullptr : folder;
    } catch (const core::FileError&) {
        return nullptr;
    }
}
} // namespace

RecoveryStore* RecoveryStore::s_present = nullptr;

/// Of the XDG base directories; where there are none, beside the program's other data.
std::filesystem::path RecoveryStore::defaultRoot()
{
    QString state = qEnvironmentVariable("XDG_STATE_HOME");
#if defined(Q_OS_UNIX) && !defined(Q_OS_MACOS)
    if (!QDir::isAbsolutePath(state))
        state = QDir::homePath() + QStringLiteral("/.local/state");
    return toPath(state + QStringLiteral("/fettle/journals"));
#else
    if (!QDir::isAbsolutePath(state))
        state = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return toPath(state + QStringLiteral("/journals"));
#endif
}

RecoveryStore::RecoveryStore(std::filesystem::path root, core::JournalLimits limits)
    : m_root(std::move(root))
    , m_limits(limits)
{
    Q_ASSERT(!s_present);
    s_present = this;
    setRetryInterval(defaultRetryInterval);
    m_retryTimer.setSingleShot(true);
    connect(&m_retryTimer, &QTimer::timeout, this, &RecoveryStore::retryDue);
    static const int registered = std::atexit(atExit);
    Q_UNUSED(registered)
}

RecoveryStore::~RecoveryStore()
{
    s_present = nullptr;
    for (const auto& journal : m_open)
        journal->remove();
}

void RecoveryStore::atExit()
{
    if (!s_present)
        return;
    const std::lock_guard lock(s_present->m_mutex);
    for (const auto& journal : s_present->m_open) {
        journal->flush();
        const auto document = core::recoverJournal(journal->folder(), {.mesh = false});
        if (document && document->isUnsaved())
            say(tr("The program ended from outside; the changes to %1 are kept, and offered at the next start.")
                    .arg(QString::fromStdString(document->document.name)));
    }
}

// --- journals of documents that are open

std::shared_ptr<core::Journal> RecoveryStore::begin(const LoadedModel& model)
{
    try {
        const core::StartRecord start{
            model.start,
            {text(model.name), text(model.path), model.metadata, model.isUnsaved || !model.repairs.isEmpty()}};
        auto journal = core::Journal::begin(m_root, start, callbacks(), m_limits);
        const std::lock_guard lock(m_mutex);
        m_open.push_back(journal);
        return journal;
    } catch (const core::FileError& error) {
        callbacks().broken(error);
    } catch (const std::bad_alloc&) {
        callbacks().broken(core::FileError(core::FileErrorKind::WriteFailed, m_root));
    }
    return nullptr;
}

core::JournalCallbacks RecoveryStore::callbacks()
{
    return {.broken = [this](const core::FileError& error) { m_mailbox.post([this, error] { reportFailure(error); }); },
            .late = [this](double ms) { m_mailbox.post([this, ms] { reportLate(ms); }); },
            .begun = [this] { m_mailbox.post([this] { onJournalBegun(); }); }};
}

void RecoveryStore::discard(std::shared_ptr<core::Journal> journal)
{
    if (!journal)
        return;
    {
        const std::lock_guard lock(m_mutex);
        std::erase(m_open, journal);
    }
    m_background.run([journal = std::move(journal)] { journal->remove(); });
}

// --- the present one, and when it fails

void RecoveryStore::setRetryInterval(std::chrono::milliseconds interval)
{
    m_retryInterval = m_nextRetryInterval = interval;
}

void RecoveryStore::setPresent(std::shared_ptr<core::Journal> journal)
{
    m_journal = std::move(journal);
    for (auto& before : std::exchange(m_superseded, {}))
        discard(std::move(before));
    if (m_journal && !m_journal->isBroken())
        reportRecording();
}

void RecoveryStore::findSpace(quint64 faces)
{
    m_background.run(
        [root = m_root, bytes = bytesPerFace * faces + m_limits.segmentBytes] { return makeFolderIfRoom(root, bytes); },
        [this](const std::shared_ptr<core::JournalFolder>& folder) {
            if (folder)
                Q_EMIT spaceFound(folder);
            else
                m_retryTimer.start(m_nextRetryInterval);
        });
}

std::shared_ptr<core::Journal> RecoveryStore::beginDeferred(const std::shared_ptr<core::JournalFolder>& folder,
                                                            quint32 present)
{
    auto journal = core::Journal::beginDeferred(folder, present, callbacks(), m_limits);
    if (const auto before = std::exchange(m_journal, journal))
        m_superseded.push_back(before);
    const std::lock_guard lock(m_mutex);
    m_open.push_back(journal);
    return journal;
}

/// A failure of another journal than the present one is noticed by the receiver of retryDue().
void RecoveryStore::reportFailure(const core::FileError& error)
{
    if (!std::exchange(m_isFailing, true))
        Q_EMIT noticed(tr("Should the program end unexpectedly, changes since the last save would be lost: %1")
                           .arg(ui::ErrorMessages::sentence(error)));
    m_retryTimer.start(m_nextRetryInterval);
    m_nextRetryInterval = std::min(2 * m_nextRetryInterval, maxRetryInterval);
}

void RecoveryStore::reportLate(double ms)
{
    if (!std::exchange(m_hasBeenLate, true))
        Q_EMIT noticed(tr("The disk is slow: a power cut could cost the changes of the last %1 seconds.")
                           .arg(QLocale().toString(ms / 1000, 'f', 1)));
}

void RecoveryStore::reportRecording()
{
    m_nextRetryInterval = m_retryInterval;
    if (std::exchange(m_isFailing, false))
        Q_EMIT noticed(tr("Changes are recorded again: should the program end unexpectedly, they come back."));
}

void RecoveryStore::onJournalBegun()
{
    if (!m_journal || m_journal->isBroken())
        return;
    for (auto& before : std::exchange(m_superseded, {}))
        discard(std::move(before));
    m_background.run([damaged = std::exchange(m_damaged, {}), root = m_root] {
        for (const auto& folder : damaged)
            putAside(*folder, {}, root);
    });
    reportRecording();
}
} // namespace app
