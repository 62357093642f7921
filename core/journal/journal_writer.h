#pragma once

#include "core/journal/append_file.h"
#include "core/journal/journal_record.h"

#include "core/util/file_error.h"

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
    /// In memory; if more waits when a change comes, the disk is too slow, and nothing is recorded any more.
    std::size_t waitingBytes = std::size_t(512) << 20;
    double promisedMs = 200; ///< from a change until it outlives a power cut
};

/// Callbacks of a journal, called on one of its threads.
struct JournalCallbacks
{
    std::function<void(const FileError&)> broken; ///< once: nothing is recorded any more
    std::function<void(double ms)> late; ///< once: the disk does not hold what is promised, so long did it take
    std::function<void()> begun; ///< of one that begins with a base: all that was before is in it, whatever happens
};

/// What a journal costs. Times in milliseconds.
struct JournalStats
{
    std::uint64_t records = 0, bytes = 0, compactions = 0;
    double packMs = 0, writeMs = 0; ///< on the writing thread, sums
    double worstWrittenMs = 0;      ///< from add() until it outlives the process
    double worstSyncedMs = 0;       ///< from add() until it outlives a power cut
    std::uint64_t late = 0;         ///< so often that took longer than promised
    bool isCompacting = false;      ///< just now
};

/// Appends records to a journal's folder, on threads of its own: one writes what comes at once, one syncs what was
/// written, one makes bases when the log is long. Every function but the constructor and the destructor may be called
/// from any thread and returns at once.
class JournalWriter
{
public:
    struct Place
    {
        std::uint64_t nextRecord = 1;
        unsigned nextSegment = 0;
        bool waits = false; ///< for begin()
    };

    /// Of a folder with a start. Syncs that, too.
    JournalWriter(std::filesystem::path folder, Place place, JournalCallbacks callbacks, JournalLimits limits = {});
    /// All that was added is written and synced before.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    void add(JournalRecord record);
    /// What makes the folder, with a start, on the writing thread; what was added waits in memory until then. It may
    /// throw FileError and std::bad_alloc.
    void begin(std::function<void()> make);
    /// Runs it when all that was added before outlives the process, or nothing is recorded any more: in order, here or
    /// on the writing thread. Of a journal that has not begun: here, at once.
    void after(std::function<void()> run);
    /// Waits until all that was added outlives the process, or nothing is recorded any more.
    void drain();
    /// Waits until all that was added is synced, or nothing is recorded any more.
    void flush();
    bool isBroken() const; ///< nothing is recorded any more
    JournalStats stats() const;

private:
    struct Task
    {
        std::function<void()> run;
    };
    struct Entry
    {
        std::variant<JournalRecord, Task> what;
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
    bool mayWrite() const;
    bool isWritten() const;
    void write();
    void beginFolder(std::function<void()> make);
    void write(Entry& entry);
    void put(const JournalRecord& record, std::int64_t addedNs);
    void beginSegment();
    void sync();
    void syncStart();
    bool isTooLate(double ms);
    void breakOff(const FileError& error);
    void compactIfLong();
    void compact(unsigned segment);

    const std::filesystem::path m_folder;
    const JournalCallbacks m_callbacks;
    const JournalLimits m_limits;

    mutable std::mutex m_mutex; ///< guards all down to the threads, but the writing thread's own
    std::condition_variable m_wakeWriter, m_wakeSyncer, m_settled;
    std::deque<Entry> m_entries;
    std::size_t m_waitingBytes = 0;
    bool m_waits; ///< until the folder is made
    std::function<void()> m_make;
    bool m_isWriting = false, m_isEnding = false, m_isBroken = false, m_isCompacting = false;
    std::deque<std::shared_ptr<AppendFile>> m_unsynced;
    std::int64_t m_oldestUnsyncedNs = 0;
    bool m_isSyncing;                              ///< the start, to begin with
    std::map<unsigned, std::uintmax_t> m_segments; ///< sizes of those that there are
    std::uintmax_t m_compactAt;                    ///< when the segments have so many bytes
    JournalStats m_stats;

    std::uint64_t m_nextRecord; ///< the writing thread's own, as the next
    Segment m_segment;

    int m_consecutiveLate = 0; ///< the syncing thread's own, as the next
    bool m_isLateReported = false;

    std::stop_source m_stop;
    std::thread m_compactor, m_syncer, m_writer;
};

/// Makes a journal's folder ready for a writer: its start is written, not synced. Throws FileError.
void writeStart(const std::filesystem::path& folder, const StartRecord& record);
} // namespace core
