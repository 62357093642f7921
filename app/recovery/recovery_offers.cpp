// The journals that programs before left: which there are, and how their documents come back.
#include "app/recovery/recovery_store.h"

#include "app/model/model_loader.h"

#include "core/journal/journal_files.h"
#include "core/sculpt/sculptor.h"

#include <QDir>

#include <algorithm>

namespace app
{
namespace
{
constexpr std::size_t maxDamaged = 4; ///< that are kept

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

/// Of a change that was made, whole or not.
bool holdsChanges(const core::JournalFolder& folder)
{
    const core::JournalFiles files = core::filesIn(folder.path());
    return !files.bases.empty() ||
           std::ranges::any_of(files.segments, [](const auto& segment) { return segment.second > 0; });
}
} // namespace

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

/// What was saved, or never changed, is removed; what is damaged beyond that is kept elsewhere.
RecoveryStore::ScanResult RecoveryStore::scan(const std::filesystem::path& root)
{
    ScanResult found;
    for (auto& folder : core::JournalFolder::abandoned(root)) {
        std::optional<core::RecoveredDocument> document;
        try {
            document = core::recoverJournal(folder->path(), {.mesh = false});
        } catch (const std::bad_alloc&) {
            continue; // it stays
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

/// Beside the root: nothing there is looked at again.
std::filesystem::path RecoveryStore::damagedRoot(const std::filesystem::path& root)
{
    std::filesystem::path damaged = root;
    return damaged += "-damaged";
}

QString RecoveryStore::putAside(core::JournalFolder& folder, const QString& name, const std::filesystem::path& root)
{
    folder.setAside(damagedRoot(root), maxDamaged);
    if (name.isEmpty())
        return tr("What was kept of an unsaved model is damaged and cannot be opened. It is in %1.")
            .arg(text(folder.path()));
    return tr("What was kept of %1 is damaged and cannot be opened. It is in %2.").arg(name, text(folder.path()));
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
                model.notice = tr("Some of what was kept of %1 is damaged: its last steps may be missing. It is in %2.")
                                   .arg(model.name, text(damagedRoot(m_root)));
            model.sculptor = std::make_shared<core::Sculptor>(std::move(document->mesh));
            model.recovered = std::make_shared<core::RecoveredDocument>(std::move(*document));
            model.offer = offer;
        } else {
            model.problem = tr("%1 cannot be recovered: what was kept of it is damaged.").arg(model.name);
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
