#include "core/journal/journal_writer.h"

#include "core/journal/compaction.h"
#include "core/journal/journal_files.h"
#include "core/util/atomic_file.h"
#include "core/util/thread_priority.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace core
{
namespace
{
constexpr int oftenLate = 3;       ///< number of late syncs in a row that are reported: one alone may be a busy moment
constexpr double muchTooLate = 25; ///< a single sync is reported if its time exceeds this multiple of promisedMs

std::int64_t nowNs()
{
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

double msSince(std::int64_t ns)
{
    return static_cast<double>(nowNs() - ns) * 1e-6;
}

std::size_t bytesOf(const JournalRecord& record)
{
    if (const auto* change = std::get_if<ChangeRecord>(&record))
        return change->image.bytes();
    if (const auto* swap = std::get_if<SwapRecord>(&record))
        return swap->image.bytes();
    return 0;
}
} // namespace

JournalWriter::JournalWriter(std::filesystem::path folder, Place place, JournalCallbacks callbacks,
                             JournalLimits limits)
    : m_folder(std::move(folder))
    , m_callbacks(std::move(callbacks))
    , m_limits(limits)
    , m_waits(place.waits)
    , m_isSyncing(!place.waits)
    , m_segments(filesIn(m_folder).segments)
    , m_compactAt(limits.logBytes)
    , m_nextRecord(place.nextRecord)
    , m_segment{place.nextSegment, 0, nullptr}
{
    m_syncer = std::thread([this] { sync(); });
    m_writer = std::thread([this] { write(); });
}

JournalWriter::~JournalWriter()
{
    flush();
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
    }
    m_stop.request_stop();
    m_wakeWriter.notify_one();
    m_wakeSyncer.notify_one();
    m_writer.join(); // joined first, because this thread may start the compactor
    m_syncer.join();
    if (m_compactor.joinable())
        m_compactor.join();
}

void JournalWriter::add(JournalRecord record)
{
    const std::size_t bytes = bytesOf(record);
    push({std::move(record), nowNs(), bytes});
}

void JournalWriter::after(std::function<void()> run)
{
    {
        const std::lock_guard lock(m_mutex);
        if (!m_waits && (!m_entries.empty() || m_isWriting)) {
            m_entries.push_back({Task{std::move(run)}});
            return;
        }
    }
    run();
}

void JournalWriter::begin(std::function<void()> make)
{
    {
        const std::lock_guard lock(m_mutex);
        m_make = std::move(make);
    }
    m_wakeWriter.notify_one();
}

void JournalWriter::push(Entry entry)
{
    bool isTooMuch = false;
    {
        const std::lock_guard lock(m_mutex);
        if (m_isBroken)
            return;
        // The limit excludes this change, which alone may exceed it.
        isTooMuch = entry.bytes > 0 && m_waitingBytes > m_limits.waitingBytes;
        m_waitingBytes += entry.bytes;
        m_entries.push_back(std::move(entry));
    }
    m_wakeWriter.notify_one();
    if (isTooMuch)
        breakOff(FileError(FileErrorKind::WriteFailed, m_folder));
}

void JournalWriter::drain()
{
    std::unique_lock lock(m_mutex);
    m_settled.wait(lock, [this] { return isWritten(); });
}

void JournalWriter::flush()
{
    std::unique_lock lock(m_mutex);
    m_settled.wait(lock, [this] { return isWritten() && (m_isBroken || (m_unsynced.empty() && !m_isSyncing)); });
}

bool JournalWriter::isBroken() const
{
    const std::lock_guard lock(m_mutex);
    return m_isBroken;
}

JournalStats JournalWriter::stats() const
{
    const std::lock_guard lock(m_mutex);
    JournalStats stats = m_stats;
    stats.isCompacting = m_isCompacting;
    return stats;
}

void writeStart(const std::filesystem::path& folder, const StartRecord& record)
{
    AppendFile(startFile(folder)).append(pack(record, 0));
}

// --- the writing thread

bool JournalWriter::mayWrite() const
{
    return m_make || (!m_waits && !m_entries.empty());
}

/// Returns whether nothing is left that can be written. Records that wait for begin() do not count.
bool JournalWriter::isWritten() const
{
    return !m_isWriting && !mayWrite();
}

void JournalWriter::write()
{
    lowerThreadPriority(ThreadPriority::Batch);
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wakeWriter.wait(lock, [this] { return m_isEnding || mayWrite(); });
        if (!mayWrite())
            return;
        if (auto make = std::exchange(m_make, nullptr)) {
            m_isWriting = true;
            lock.unlock();
            beginFolder(std::move(make));
            lock.lock();
            m_isWriting = false;
            m_settled.notify_all();
            continue;
        }
        Entry entry = std::move(m_entries.front());
        m_entries.pop_front();
        m_waitingBytes -= entry.bytes;
        m_isWriting = true;
        lock.unlock();
        write(entry);
        entry = {};
        lock.lock();
        m_isWriting = false;
        m_settled.notify_all();
    }
}

void JournalWriter::beginFolder(std::function<void()> make)
{
    try {
        if (!isBroken())
            make();
        make = nullptr; // frees the mesh that it may own
    } catch (const FileError& error) {
        breakOff(error);
    } catch (const std::bad_alloc&) {
        breakOff(FileError(FileErrorKind::WriteFailed, m_folder));
    }
    {
        const std::lock_guard lock(m_mutex);
        m_waits = false; // after() now waits for the records added before
    }
    if (!isBroken() && m_callbacks.begun)
        m_callbacks.begun();
}

void JournalWriter::write(Entry& entry)
{
    if (const auto* task = std::get_if<Task>(&entry.what))
        return task->run();
    try {
        put(std::get<JournalRecord>(entry.what), entry.addedNs);
        compactIfLong();
    } catch (const FileError& error) {
        breakOff(error);
    } catch (const std::bad_alloc&) {
        breakOff(FileError(FileErrorKind::WriteFailed, m_folder));
    }
}

void JournalWriter::put(const JournalRecord& record, std::int64_t addedNs)
{
    {
        const std::lock_guard lock(m_mutex);
        if (m_isBroken)
            return;
    }
    const std::int64_t beganNs = nowNs();
    const std::string bytes = pack(record, m_nextRecord++);
    const double packMs = msSince(beganNs);
    if (!m_segment.file || (m_segment.bytes > 0 && m_segment.bytes + bytes.size() > m_limits.segmentBytes))
        beginSegment();
    m_segment.file->append(bytes);
    m_segment.bytes += bytes.size();
    {
        const std::lock_guard lock(m_mutex);
        m_segments[m_segment.number] = m_segment.bytes;
        if (m_unsynced.empty())
            m_oldestUnsyncedNs = addedNs;
        if (m_unsynced.empty() || m_unsynced.back() != m_segment.file)
            m_unsynced.push_back(m_segment.file);
        ++m_stats.records;
        m_stats.bytes += bytes.size();
        m_stats.packMs += packMs;
        m_stats.writeMs += msSince(beganNs) - packMs;
        m_stats.worstWrittenMs = std::max(m_stats.worstWrittenMs, msSince(addedNs));
    }
    m_wakeSyncer.notify_one();
}

void JournalWriter::beginSegment()
{
    if (m_segment.file)
        ++m_segment.number;
    m_segment.file = std::make_shared<AppendFile>(segmentFile(m_folder, m_segment.number));
    m_segment.bytes = 0;
}

void JournalWriter::breakOff(const FileError& error)
{
    {
        const std::lock_guard lock(m_mutex);
        if (std::exchange(m_isBroken, true))
            return;
    }
    m_settled.notify_all();
    if (m_callbacks.broken)
        m_callbacks.broken(error);
}

// --- the syncing thread

void JournalWriter::sync()
{
    lowerThreadPriority(ThreadPriority::Batch);
    if (m_isSyncing)
        syncStart();
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_isSyncing = false;
        m_settled.notify_all();
        m_wakeSyncer.wait(lock, [this] { return m_isEnding || !m_unsynced.empty(); });
        if (m_unsynced.empty())
            return;
        const auto files = std::exchange(m_unsynced, {});
        const std::int64_t oldestNs = m_oldestUnsyncedNs;
        m_isSyncing = true;
        lock.unlock();
        try {
            for (const auto& file : files)
                file->sync();
            syncFolder(m_folder);
        } catch (const FileError& error) {
            breakOff(error);
        }
        const double ms = msSince(oldestNs);
        if (isTooLate(ms) && m_callbacks.late)
            m_callbacks.late(ms);
        lock.lock();
        m_stats.worstSyncedMs = std::max(m_stats.worstSyncedMs, ms);
        m_stats.late += ms > m_limits.promisedMs;
    }
}

/// Syncs the start file as soon as the thread runs, so that the first change need not wait for it.
void JournalWriter::syncStart()
{
    try {
        syncFile(startFile(m_folder));
        syncFolder(m_folder.parent_path());
    } catch (const FileError& error) {
        breakOff(error);
    }
}

/// Returns whether it must now be reported that syncs are late. `ms`: time from add() of the oldest record to the end
/// of its sync. Thread: the syncing thread.
bool JournalWriter::isTooLate(double ms)
{
    if (m_isLateReported)
        return false;
    m_consecutiveLate = ms > m_limits.promisedMs ? m_consecutiveLate + 1 : 0;
    m_isLateReported = m_consecutiveLate >= oftenLate || ms > muchTooLate * m_limits.promisedMs;
    return m_isLateReported;
}

// --- the compacting thread

/// Starts compaction if the segments are too large together. Selects the oldest segments until the rest is at most half
/// of logBytes; the segment that is being written is kept.
void JournalWriter::compactIfLong()
{
    unsigned segment = 0;
    {
        const std::lock_guard lock(m_mutex);
        std::uintmax_t bytes = 0;
        for (const auto& each : m_segments)
            bytes += each.second;
        if (bytes <= m_compactAt || m_isCompacting || m_isEnding)
            return;
        auto first = m_segments.begin();
        for (; first->first < m_segment.number && bytes > m_limits.logBytes / 2; ++first)
            bytes -= first->second;
        if (first == m_segments.begin())
            return;
        segment = first->first;
        m_isCompacting = true;
    }
    if (m_compactor.joinable())
        m_compactor.join();
    m_compactor = std::thread([this, segment] { compact(segment); });
}

void JournalWriter::compact(unsigned segment)
{
    lowerThreadPriority(ThreadPriority::Idle);
    const bool isDone = compactJournal(m_folder, segment, m_stop.get_token());
    const std::lock_guard lock(m_mutex);
    m_compactAt = m_limits.logBytes;
    if (isDone) {
        m_segments.erase(m_segments.begin(), m_segments.lower_bound(segment));
        ++m_stats.compactions;
    } else { // try again only when the log has grown by another logBytes
        for (const auto& each : m_segments)
            m_compactAt += each.second;
    }
    m_isCompacting = false;
}
} // namespace core
