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

constexpr std::chrono::milliseconds usualPatience = std::chrono::seconds(10), longestWait = std::chrono::minutes(5);
constexpr std::uintmax_t bytesAFace = 128; ///< of a start and a base, with some free slots

/// Null if there is no room, or it may not be.
std::shared_ptr<core::JournalFolder> roomIn(const std::filesystem::path& root, std::uintmax_t bytes)
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

JournalShelf* JournalShelf::s_present = nullptr;

/// Of the XDG base directories; where there are none, beside the program's other data.
std::filesystem::path JournalShelf::usualRoot()
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

JournalShelf::JournalShelf(std::filesystem::path root, core::JournalLimits limits)
    : m_root(std::move(root))
    , m_limits(limits)
{
    Q_ASSERT(!s_present);
    s_present = this;
    setPatience(usualPatience);
    m_again.setSingleShot(true);
    connect(&m_again, &QTimer::timeout, this, &JournalShelf::mayRecord);
    static const int registered = std::atexit(atExit);
    Q_UNUSED(registered)
}

JournalShelf::~JournalShelf()
{
    s_present = nullptr;
    for (const auto& journal : m_open)
        journal->remove();
}

void JournalShelf::atExit()
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

std::shared_ptr<core::Journal> JournalShelf::begin(const LoadedModel& model)
{
    try {
        const core::StartRecord start{
            model.start,
            {text(model.name), text(model.path), model.metadata, model.isUnsaved || !model.mended.isEmpty()}};
        auto journal = core::Journal::begin(m_root, start, news(), m_limits);
        const std::lock_guard lock(m_mutex);
        m_open.push_back(journal);
        return journal;
    } catch (const core::FileError& error) {
        news().broken(error);
    } catch (const std::bad_alloc&) {
        news().broken(core::FileError(core::FileErrorKind::WriteFailed, m_root));
    }
    return nullptr;
}

core::JournalCallbacks JournalShelf::news()
{
    return {.broken = [this](const core::FileError& error) { m_mail.post([this, error] { tellFailure(error); }); },
            .late = [this](double ms) { m_mail.post([this, ms] { tellLate(ms); }); },
            .begun = [this] { m_mail.post([this] { takeBegun(); }); }};
}

void JournalShelf::discard(std::shared_ptr<core::Journal> journal)
{
    if (!journal)
        return;
    {
        const std::lock_guard lock(m_mutex);
        std::erase(m_open, journal);
    }
    m_aside.run([journal = std::move(journal)] { journal->remove(); });
}

// --- the present one, and when it fails

void JournalShelf::setPatience(std::chrono::milliseconds patience)
{
    m_patience = m_wait = patience;
}

void JournalShelf::setPresent(std::shared_ptr<core::Journal> journal)
{
    m_journal = std::move(journal);
    for (auto& before : std::exchange(m_superseded, {}))
        discard(std::move(before));
    if (m_journal && !m_journal->isBroken())
        tellWorks();
}

void JournalShelf::findRoom(quint64 faces)
{
    m_aside.run([root = m_root, bytes = bytesAFace * faces + m_limits.segmentBytes] { return roomIn(root, bytes); },
                [this](const std::shared_ptr<core::JournalFolder>& folder) {
                    if (folder)
                        Q_EMIT roomFound(folder);
                    else
                        m_again.start(m_wait);
                });
}

std::shared_ptr<core::Journal> JournalShelf::beginDeferred(const std::shared_ptr<core::JournalFolder>& folder,
                                                           quint32 present)
{
    auto journal = core::Journal::beginDeferred(folder, present, news(), m_limits);
    if (const auto before = std::exchange(m_journal, journal))
        m_superseded.push_back(before);
    const std::lock_guard lock(m_mutex);
    m_open.push_back(journal);
    return journal;
}

/// That of some other journal than the present one is found out by who hears mayRecord().
void JournalShelf::tellFailure(const core::FileError& error)
{
    if (!std::exchange(m_isFailing, true))
        Q_EMIT told(tr("Should the program end unexpectedly, changes since the last save would be lost: %1")
                        .arg(ui::ErrorMessages::sentence(error)));
    m_again.start(m_wait);
    m_wait = std::min(2 * m_wait, longestWait);
}

void JournalShelf::tellLate(double ms)
{
    if (!std::exchange(m_hasBeenLate, true))
        Q_EMIT told(tr("The disk is slow: a power cut could cost the changes of the last %1 seconds.")
                        .arg(QLocale().toString(ms / 1000, 'f', 1)));
}

void JournalShelf::tellWorks()
{
    m_wait = m_patience;
    if (std::exchange(m_isFailing, false))
        Q_EMIT told(tr("Changes are recorded again: should the program end unexpectedly, they come back."));
}

void JournalShelf::takeBegun()
{
    if (!m_journal || m_journal->isBroken())
        return;
    for (auto& before : std::exchange(m_superseded, {}))
        discard(std::move(before));
    m_aside.run([damaged = std::exchange(m_damaged, {}), root = m_root] {
        for (const auto& folder : damaged)
            putAside(*folder, {}, root);
    });
    tellWorks();
}
} // namespace app
