#include "app/recovery/recovery_store.h"

#include "app/model/model_loader.h"
#include "app/platform/desktop.h"

#include "core/journal/journal_files.h"
#include "core/sculpt/sculptor.h"
#include "ui/util/error_messages.h"

#include <QDir>
#include <QLocale>

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
/// estimated size of a journal's start and base records, including unused slots, bytes per face
constexpr std::uintmax_t bytesPerFace = 128;

/// Returns a new journal folder; null if the disk has too little space or the folder cannot be made.
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

constexpr std::size_t maxDamaged = 4; ///< number of damaged journals that are kept

QDateTime toDateTime(std::filesystem::file_time_type time)
{
    using namespace std::chrono;
    const auto system = time_point_cast<milliseconds>(file_clock::to_sys(time));
    return QDateTime::fromMSecsSinceEpoch(system.time_since_epoch().count());
}

QString text(const std::filesystem::path& path)
{
    return QDir::toNativeSeparators(QString::fromStdU16String(path.u16string()));
}

/// Returns whether the folder contains a record of a change, complete or not.
bool holdsChanges(const core::JournalFolder& folder)
{
    const core::JournalFiles files = core::filesIn(folder.path());
    return !files.bases.empty() ||
           std::ranges::any_of(files.segments, [](const auto& segment) { return segment.second > 0; });
}
} // namespace

RecoveryStore* RecoveryStore::s_present = nullptr;

std::filesystem::path RecoveryStore::defaultRoot()
{
    return toPath(stateFolder() + QStringLiteral("/journals"));
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
            say(tr("Fettle was ended from outside. The changes to %1 are kept; the next start offers them.")
                    .arg(QString::fromStdString(document->document.name)));
    }
}

// --- journals of open documents

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

// --- the present document's journal, and its failures

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

/// Reports a failure once, and starts the retry timer. The failed journal may not be the present one; the receiver of
/// retryDue() checks that.
void RecoveryStore::reportFailure(const core::FileError& error)
{
    if (!std::exchange(m_isFailing, true))
        Q_EMIT noticed(tr("Changes are not being recorded, so save often: %1").arg(ui::ErrorMessages::sentence(error)));
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
        Q_EMIT noticed(tr("Changes are being recorded again."));
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

// --- journals that earlier runs left behind

void RecoveryStore::findAbandoned()
{
    m_background.run([root = m_root] { return std::make_shared<ScanResult>(scan(root)); },
                     [this](const std::shared_ptr<ScanResult>& found) {
                         {
                             const std::lock_guard lock(m_mutex);
                             m_abandoned = std::move(found->abandoned);
                         }
                         offerNext();
                         for (const QString& sentence : found->notices)
                             Q_EMIT noticed(sentence);
                     });
}

/// Reads the journals left by earlier runs and returns those with unsaved changes. Of the others, sets damaged ones
/// aside and removes the rest.
RecoveryStore::ScanResult RecoveryStore::scan(const std::filesystem::path& root)
{
    ScanResult found;
    for (auto& folder : core::JournalFolder::abandoned(root)) {
        std::optional<core::RecoveredDocument> document;
        try {
            document = core::recoverJournal(folder->path(), {.mesh = false});
        } catch (const std::bad_alloc&) {
            continue; // not removed: a later run may have enough memory
        }
        const QString name = document ? QString::fromStdString(document->document.name) : QString();
        if (document && document->isUnsaved())
            found.abandoned.push_back({{found.abandoned.size() + 1, name, toDateTime(folder->changed()),
                                        static_cast<int>(document->history.present)},
                                       std::move(folder)});
        else if (document ? document->isDamaged : holdsChanges(*folder))
            found.notices.append(putAside(*folder, name, root));
        else
            folder->remove();
    }
    return found;
}

/// Returns the folder for damaged journals. It is beside `root`, because scan() reads everything inside `root`.
std::filesystem::path RecoveryStore::damagedRoot(const std::filesystem::path& root)
{
    std::filesystem::path damaged = root;
    return damaged += "-damaged";
}

QString RecoveryStore::putAside(core::JournalFolder& folder, const QString& name, const std::filesystem::path& root)
{
    folder.setAside(damagedRoot(root), maxDamaged);
    if (name.isEmpty())
        return tr("The recording of an unsaved model is damaged and cannot be opened. It is in %1.")
            .arg(text(folder.path()));
    return tr("The recording of %1 is damaged and cannot be opened. It is in %2.").arg(name, text(folder.path()));
}

void RecoveryStore::offerNext()
{
    RecoveryOffer next;
    {
        const std::lock_guard lock(m_mutex);
        if (!m_abandoned.empty())
            next = m_abandoned.front().offer;
    }
    Q_EMIT offered(next);
}

LoadedModel RecoveryStore::recover(quint64 offer, const core::JobControl& control)
{
    std::filesystem::path folder;
    LoadedModel model;
    {
        const std::lock_guard lock(m_mutex);
        const auto found =
            std::ranges::find(m_abandoned, offer, [](const AbandonedJournal& each) { return each.offer.id; });
        if (found != m_abandoned.end()) {
            folder = found->folder->path();
            model.name = found->offer.name;
        }
    }
    try {
        if (auto document = core::recoverJournal(folder, {.stop = control.stop})) {
            model.name = QString::fromStdString(document->document.name);
            model.path = QString::fromStdString(document->document.path);
            model.metadata = document->document.metadata;
            model.start = document->start;
            if (document->isDamaged)
                model.notice = tr("Part of the recording of %1 is damaged: its last steps may be missing. It is in %2.")
                                   .arg(model.name, text(damagedRoot(m_root)));
            model.sculptor = std::make_shared<core::Sculptor>(std::move(document->mesh));
            model.recovered = std::make_shared<core::RecoveredDocument>(std::move(*document));
            model.offer = offer;
        } else {
            model.problem = tr("%1 cannot be recovered: its recording is damaged.").arg(model.name);
        }
    } catch (const std::bad_alloc&) {
        model.problem = tr("%1: there is not enough memory for this model.").arg(model.name);
    }
    return model;
}

std::shared_ptr<core::Journal> RecoveryStore::resume(quint64 offer, const core::RecoveredDocument& document)
{
    AbandonedJournal abandoned = takeAbandoned(offer);
    if (document.isDamaged) {
        m_damaged.push_back(std::move(abandoned.folder));
        m_retryTimer.start(0);
        offerNext();
        return nullptr;
    }
    auto journal = core::Journal::resume(std::move(abandoned.folder), document, callbacks(), m_limits);
    {
        const std::lock_guard lock(m_mutex);
        m_open.push_back(journal);
    }
    offerNext();
    return journal;
}

void RecoveryStore::discard(quint64 offer)
{
    const auto folder = std::make_shared<std::unique_ptr<core::JournalFolder>>(takeAbandoned(offer).folder);
    m_background.run([folder] {
        if (*folder)
            (*folder)->remove();
    });
    offerNext();
}

RecoveryStore::AbandonedJournal RecoveryStore::takeAbandoned(quint64 offer)
{
    const std::lock_guard lock(m_mutex);
    const auto found =
        std::ranges::find(m_abandoned, offer, [](const AbandonedJournal& each) { return each.offer.id; });
    if (found == m_abandoned.end())
        return {};
    AbandonedJournal abandoned = std::move(*found);
    m_abandoned.erase(found);
    return abandoned;
}
} // namespace app
