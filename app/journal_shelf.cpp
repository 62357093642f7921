#include "journal_shelf.h"

#include "model_loader.h"

#include "ui/messages.h"

#include <QDir>
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

QDateTime toDateTime(std::filesystem::file_time_type time)
{
    using namespace std::chrono;
    const auto system = time_point_cast<milliseconds>(file_clock::to_sys(time));
    return QDateTime::fromMSecsSinceEpoch(system.time_since_epoch().count());
}

std::string text(const QString& string)
{
    return string.toUtf8().toStdString();
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

JournalShelf::JournalShelf(std::filesystem::path root, core::JournalLimits limits) : m_root(std::move(root)), m_limits(limits)
{
    Q_ASSERT(!s_present);
    s_present = this;
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
        const auto document = core::replayJournal(journal->folder(), {.mesh = false});
        if (document && document->isUnsaved())
            say(tr("The program ended from outside; the changes to %1 are kept, and offered at the next start.")
                    .arg(QString::fromStdString(document->document.name)));
    }
}

// --- journals of documents that are open -----------------------------------------------------------------------------------------

std::shared_ptr<core::Journal> JournalShelf::begin(const LoadedModel& model)
{
    try {
        const core::StartRecord start{model.start, {text(model.name), text(model.path), model.notes, !model.mended.isEmpty()}};
        auto journal = core::Journal::begin(m_root, start, teller(), m_limits);
        const std::lock_guard lock(m_mutex);
        m_open.push_back(journal);
        return journal;
    } catch (const core::FileError& error) {
        teller()(error);
    } catch (const std::bad_alloc&) {
        teller()(core::FileError(core::FileErrorKind::WriteFailed, m_root));
    }
    return nullptr;
}

core::JournalWriter::Broken JournalShelf::teller()
{
    return [this](const core::FileError& error) { m_mail.post([this, error] { tellFailure(error); }); };
}

void JournalShelf::tellFailure(const core::FileError& error)
{
    if (!std::exchange(m_hasFailed, true))
        Q_EMIT failed(tr("Should the program end unexpectedly, changes since the last save would be lost: %1").arg(ui::Messages::sentence(error)));
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

// --- journals that were left -----------------------------------------------------------------------------------------------------

void JournalShelf::look()
{
    m_aside.run([root = m_root] { return std::make_shared<std::vector<Left>>(leftIn(root)); },
                [this](const std::shared_ptr<std::vector<Left>>& left) {
                    {
                        const std::lock_guard lock(m_mutex);
                        m_left = std::move(*left);
                    }
                    offerNext();
                });
}

/// What was saved, or never changed, is removed.
std::vector<JournalShelf::Left> JournalShelf::leftIn(const std::filesystem::path& root)
{
    std::vector<Left> left;
    for (auto& folder : core::JournalFolder::abandoned(root)) {
        const auto document = core::replayJournal(folder->path(), {.mesh = false});
        if (!document || !document->isUnsaved()) {
            folder->remove();
            continue;
        }
        RecoveryOffer offer{left.size() + 1, QString::fromStdString(document->document.name), toDateTime(folder->changed()),
                            static_cast<int>(document->history.present)};
        left.push_back({std::move(offer), std::move(folder)});
    }
    return left;
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

LoadedModel JournalShelf::recover(quint64 offer, const core::JobWatch& watch)
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
        if (auto document = core::replayJournal(folder, {.stop = watch.stop})) {
            model.name = QString::fromStdString(document->document.name);
            model.path = QString::fromStdString(document->document.path);
            model.notes = document->document.notes;
            model.start = document->start;
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
    auto journal = core::Journal::goOn(std::move(left.folder), document, teller(), m_limits);
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
