// The journals that programs before left: which there are, and how their documents come back.
#include "app/recovery/recovery_store.h"

#include "app/model/model_loader.h"

#include "core/journal/journal_files.h"

#include <QDir>

#include <algorithm>

namespace app
{
namespace
{
constexpr std::size_t mostDamaged = 4; ///< that are kept

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

void JournalShelf::look()
{
    m_aside.run([root = m_root] { return std::make_shared<Found>(foundIn(root)); },
                [this](const std::shared_ptr<Found>& found) {
                    {
                        const std::lock_guard lock(m_mutex);
                        m_left = std::move(found->left);
                    }
                    offerNext();
                    for (const QString& sentence : found->told)
                        Q_EMIT told(sentence);
                });
}

/// What was saved, or never changed, is removed; what is damaged beyond that is kept elsewhere.
JournalShelf::Found JournalShelf::foundIn(const std::filesystem::path& root)
{
    Found found;
    for (auto& folder : core::JournalFolder::abandoned(root)) {
        std::optional<core::RecoveredDocument> document;
        try {
            document = core::recoverJournal(folder->path(), {.mesh = false});
        } catch (const std::bad_alloc&) {
            continue; // it stays
        }
        const QString name = document ? QString::fromStdString(document->document.name) : QString();
        if (document && document->isUnsaved())
            found.left.push_back({{found.left.size() + 1, name, toDateTime(folder->changed()),
                                   static_cast<int>(document->history.present)},
                                  std::move(folder)});
        else if (document ? document->isDamaged : holdsChanges(*folder))
            found.told.append(putAside(*folder, name, root));
        else
            folder->remove();
    }
    return found;
}

/// Beside the root: nothing there is looked at again.
std::filesystem::path JournalShelf::damagedRoot(const std::filesystem::path& root)
{
    std::filesystem::path damaged = root;
    return damaged += "-damaged";
}

QString JournalShelf::putAside(core::JournalFolder& folder, const QString& name, const std::filesystem::path& root)
{
    folder.setAside(damagedRoot(root), mostDamaged);
    if (name.isEmpty())
        return tr("What was kept of an unsaved model is damaged and cannot be opened. It is in %1.")
            .arg(text(folder.path()));
    return tr("What was kept of %1 is damaged and cannot be opened. It is in %2.").arg(name, text(folder.path()));
}

void JournalShelf::offerNext()
{
    RecoveryOffer next;
    {
        const std::lock_guard lock(m_mutex);
        if (!m_left.empty())
            next = m_left.front().offer;
    }
    Q_EMIT offered(next);
}

LoadedModel JournalShelf::recover(quint64 offer, const core::JobControl& control)
{
    std::filesystem::path folder;
    LoadedModel model;
    {
        const std::lock_guard lock(m_mutex);
        const auto found = std::ranges::find(m_left, offer, [](const Left& each) { return each.offer.id; });
        if (found != m_left.end()) {
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

std::shared_ptr<core::Journal> JournalShelf::goOn(quint64 offer, const core::RecoveredDocument& document)
{
    Left left = take(offer);
    if (document.isDamaged) {
        m_damaged.push_back(std::move(left.folder));
        m_again.start(0);
        offerNext();
        return nullptr;
    }
    auto journal = core::Journal::resume(std::move(left.folder), document, news(), m_limits);
    {
        const std::lock_guard lock(m_mutex);
        m_open.push_back(journal);
    }
    offerNext();
    return journal;
}

void JournalShelf::discard(quint64 offer)
{
    const auto folder = std::make_shared<std::unique_ptr<core::JournalFolder>>(take(offer).folder);
    m_aside.run([folder] {
        if (*folder)
            (*folder)->remove();
    });
    offerNext();
}

JournalShelf::Left JournalShelf::take(quint64 offer)
{
    const std::lock_guard lock(m_mutex);
    const auto found = std::ranges::find(m_left, offer, [](const Left& each) { return each.offer.id; });
    if (found == m_left.end())
        return {};
    Left left = std::move(*found);
    m_left.erase(found);
    return left;
}
} // namespace app
