#include "app/document/history_store.h"

#include "core/journal/journal.h"
#include "core/sculpt/sculptor.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <fstream>
#include <new>

namespace app
{
StoredDelta::StoredDelta(std::shared_ptr<core::MeshDelta> delta) : m_delta(std::move(delta)) {}

StoredDelta::~StoredDelta()
{
    drop();
}

std::shared_ptr<core::MeshDelta> StoredDelta::swap(core::Sculptor& sculptor)
{
    if (!m_delta && !load())
        return nullptr;
    sculptor.swap(*m_delta);
    return m_delta;
}

bool StoredDelta::spill(const QString& folder)
{
    if (!m_delta)
        return true;
    if (folder.isEmpty())
        return false;
    const QString path = QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
    m_file = path.toStdU16String();
    std::ofstream out(m_file, std::ios::binary);
    m_delta->write(out);
    out.close();
    if (!out) {
        removeFile();
        return false;
    }
    m_delta.reset();
    return true;
}

bool StoredDelta::load()
{
    if (m_file.empty())
        return false;
    std::ifstream in(m_file, std::ios::binary);
    auto delta = std::make_shared<core::MeshDelta>(core::MeshDelta::read(in));
    if (!in)
        return false;
    in.close(); // Windows removes no open file
    m_delta = std::move(delta);
    removeFile();
    return true;
}

std::optional<core::MeshDelta> StoredDelta::copy() const
{
    try {
        if (m_delta)
            return *m_delta;
        std::ifstream in(m_file, std::ios::binary);
        core::MeshDelta delta = core::MeshDelta::read(in);
        return in ? std::optional(std::move(delta)) : std::nullopt;
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

void StoredDelta::drop()
{
    m_delta.reset();
    removeFile();
}

void StoredDelta::removeFile()
{
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
    m_file.clear();
}

std::size_t StoredDelta::bytesInMemory() const
{
    return m_delta ? m_delta->bytes() : 0;
}

HistoryStore::HistoryStore(Post post, QObject* parent)
    : QObject(parent)
    , m_post(std::move(post))
    , m_meshSide(std::make_shared<MeshSide>())
{}

HistoryStore::~HistoryStore() = default;

void HistoryStore::setCap(std::size_t bytes)
{
    m_cap = bytes;
    enforceCap();
}

void HistoryStore::setFolder(const QString& folder)
{
    m_folder = folder;
}

void HistoryStore::add(int index, std::shared_ptr<core::MeshDelta> delta)
{
    m_entries.resize(static_cast<std::size_t>(index));
    const std::size_t bytes = delta->bytes();
    m_entries.push_back({std::make_shared<StoredDelta>(std::move(delta)), bytes});
    m_present = m_end = index + 1;
    enforceCap();
}

void HistoryStore::setJournal(std::shared_ptr<core::Journal> journal)
{
    m_journal = std::move(journal);
}

void HistoryStore::restore(const std::vector<std::shared_ptr<core::MeshDelta>>& deltas, int present)
{
    m_entries.clear();
    for (const auto& delta : deltas)
        m_entries.push_back({std::make_shared<StoredDelta>(delta), delta ? delta->bytes() : 0});
    m_present = m_first = m_end = present;
    while (m_first > 0 && deltas[static_cast<std::size_t>(m_first) - 1])
        --m_first;
    while (m_end < static_cast<int>(deltas.size()) && deltas[static_cast<std::size_t>(m_end)])
        ++m_end;
    enforceCap();
}

void HistoryStore::swap(int index)
{
    if (index >= static_cast<int>(m_entries.size()))
        return;
    const auto& delta = m_entries.at(static_cast<std::size_t>(index)).delta;
    m_present = index < m_present ? index : index + 1;
    m_post([this, delta, index, meshSide = m_meshSide, journal = m_journal](core::Sculptor& sculptor) {
        if (meshSide->broken)
            return;
        const std::shared_ptr<const core::MeshDelta> swapped = delta->swap(sculptor);
        meshSide->broken = !swapped;
        if (swapped && journal)
            journal->swapped(sculptor.mesh(), *swapped, static_cast<std::uint32_t>(index));
        m_mailbox.post([this, delta, bytes = delta->bytesInMemory(), isLost = meshSide->broken] {
            noteBytes(delta, bytes);
            if (isLost)
                Q_EMIT lost();
        });
    });
}

void HistoryStore::clear()
{
    m_entries.clear();
    m_present = m_first = m_end = 0;
    m_post([meshSide = m_meshSide](core::Sculptor&) { meshSide->broken = false; });
}

std::size_t HistoryStore::bytesInMemory() const
{
    std::size_t sum = 0;
    for (const Entry& entry : m_entries)
        sum += entry.bytes;
    return sum;
}

void HistoryStore::noteBytes(const std::shared_ptr<StoredDelta>& delta, std::size_t bytes)
{
    for (Entry& entry : m_entries)
        if (entry.delta == delta)
            entry.bytes = bytes;
    enforceCap();
    Q_EMIT bytesChanged();
}

void HistoryStore::enforceCap()
{
    while (bytesInMemory() > m_cap) {
        const int position = farthestInMemory();
        if (position < 0)
            break;
        spill(position);
    }
}

/// Returns the index of the entry in memory that is the most steps away; -1: none. The entries of the next undo and of
/// the next redo are never returned.
int HistoryStore::farthestInMemory() const
{
    int farthest = -1, steps = 1;
    for (int i = m_first; i < m_end; ++i) {
        const int away = i < m_present ? m_present - i : i - m_present + 1;
        if (m_entries[static_cast<std::size_t>(i)].bytes > 0 && away > steps) {
            farthest = i;
            steps = away;
        }
    }
    return farthest;
}

void HistoryStore::spill(int position)
{
    Entry& entry = m_entries[static_cast<std::size_t>(position)];
    entry.bytes = 0;
    if (m_folder.isEmpty())
        makeOwnFolder();
    m_post([this, delta = entry.delta, folder = m_folder](core::Sculptor&) {
        if (!delta->spill(folder))
            m_mailbox.post([this, delta] { spillFailed(delta); });
    });
}

/// Makes a folder in the user's cache: the system's temporary folder is often in memory.
void HistoryStore::makeOwnFolder()
{
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    QDir().mkpath(cache);
    m_ownFolder = std::make_unique<QTemporaryDir>(cache + QStringLiteral("/history-XXXXXX"));
    if (m_ownFolder->isValid())
        m_folder = m_ownFolder->path();
}

void HistoryStore::spillFailed(const std::shared_ptr<StoredDelta>& delta)
{
    const auto found =
        std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.delta == delta; });
    if (found != m_entries.end())
        expire(static_cast<int>(found - m_entries.begin()));
}

void HistoryStore::expire(int position)
{
    const bool isPast = position < m_present;
    for (int i = isPast ? m_first : position; i < (isPast ? position + 1 : m_end); ++i) {
        Entry& entry = m_entries[static_cast<std::size_t>(i)];
        entry.bytes = 0;
        m_post([delta = entry.delta](core::Sculptor&) { delta->drop(); });
    }
    if (isPast)
        m_first = position + 1;
    else
        m_end = position;
    Q_EMIT expired();
}
} // namespace app
