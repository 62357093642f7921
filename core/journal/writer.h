#pragma once

#include "append_file.h"
#include "record.h"

#include "../file_error.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

namespace core
{
struct JournalLimits
{
    std::size_t segmentBytes = std::size_t(16) << 20; ///< a segment that has so many is followed by another
    /// With more than so many in segments a new base is made, and what is before it goes: about half of it stays.
    std::size_t logBytes = std::size_t(256) << 20;
    std::size_t waitingBytes = std::size_t(512) << 20; ///< in memory; if the disk is slower than that, nothing is recorded any more
};

/// What a journal costs. Times in milliseconds.
struct JournalStats
{
    std::uint64_t records = 0, bytes = 0, compactions = 0;
    double packMs = 0, writeMs = 0; ///< on the writing thread, sums
    double worstWrittenMs = 0;      ///< from add() until it outlives the process
    double worstSyncedMs = 0;       ///< from add() until it outlives a power cut
    bool isCompacting = false;      ///< just now
};

/// Appends records to a journal's folder, on threads of its own: one writes what comes at once, one syncs what was written, one makes
/// bases when the log is long. Every function but the constructor and the destructor may be called from any thread and returns at once.
class JournalWriter
{
public:
    struct Place
    {
        std::uint64_t nextRecord = 1;
        unsigned nextSegment = 0;
    };
    /// Called once, from one of the threads: nothing is recorded any more.
    using Broken = std::function<void(const FileError&)>;

    /// Of a folder with a start. Syncs that, too.
    JournalWriter(std::filesystem::path folder, Place place, Broken broken, JournalLimits limits = {});
    /// All that was added is written and synced before.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    void add(JournalRecord record);
    /// Runs it when all that was added before outlives the process, or nothing is recorded any more: in order, here or on the writing thread.
    void after(std::function<void()> run);
    /// Waits until all that was added outlives the process, or nothing is recorded any more.
    void drain();
    /// Waits until all that was added is synced, or nothing is recorded any more.
    void flush();
    JournalStats stats() const;

private:
    struct Letter
    {
        std::function<void()> run;
    };
    struct Entry
    {
        std::variant<JournalRecord, Letter> what;
        std::int64_t addedNs = 0;
        std::size_t bytes = 0;
    };
    struct Segment
    {
        unsigned number = 0;
        std::size_t bytes = 0;
        std::shared_ptr<AppendFile> file;
    };

    void push(Entry entry);
    void write();
    void write(Entry& entry);
    void put(const JournalRecord& record, std::int64_t addedNs);
    void beginSegment();
    void sync();
    void breakOff(const FileError& error);
    void compactIfLong();
    void compact(unsigned segment);

    const std::filesystem::path m_folder;
    const Broken m_broken;
    const JournalLimits m_limits;

    mutable std::mutex m_mutex; ///< guards all down to the threads, but the writing thread's own
    std::condition_variable m_wakeWriter, m_wakeSyncer, m_settled;
    std::deque<Entry> m_entries;
    std::size_t m_waitingBytes = 0;
    bool m_isWriting = false, m_isEnding = false, m_isBroken = false, m_isCompacting = false;
    std::deque<std::shared_ptr<AppendFile>> m_unsynced;
    std::int64_t m_oldestUnsyncedNs = 0;
    bool m_isSyncing = false;
    std::map<unsigned, std::uintmax_t> m_segments; ///< sizes of those that there are
    std::uintmax_t m_compactAt; ///< when the segments have so many bytes
    JournalStats m_stats;

    std::uint64_t m_nextRecord; ///< the writing thread's own, as the next
    Segment m_segment;

    std::stop_source m_stop;
    std::thread m_compactor, m_syncer, m_writer;
};

/// Makes a journal's folder ready for a writer: its start is written, not synced. Throws FileError.
void writeStart(const std::filesystem::path& folder, const StartRecord& record);
} // namespace core
