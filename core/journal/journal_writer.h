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
    std::size_t segmentBytes = std::size_t(16) << 20; ///< largest size in bytes of a segment with more than one record
    /// Largest total size of the segments in bytes. Beyond it a new base replaces the oldest segments, so that about
    /// half of this size is left.
    std::size_t logBytes = std::size_t(256) << 20;
    /// Largest size in bytes of the records waiting in memory. If a change is added beyond it, the disk is too slow and
    /// recording stops.
    std::size_t waitingBytes = std::size_t(512) << 20;
    double promisedMs = 200; ///< time in ms from a change until it survives a power cut
};

/// Callbacks of a journal, called on one of its threads; `broken` also by add(), if too many records are waiting.
struct JournalCallbacks
{
    std::function<void(const FileError&)> broken; ///< called once, when recording has stopped
    /// Called once, when several syncs in a row were late or one was very late. `ms`: time from add() of the oldest
    /// record of the last sync to the end of this sync; promisedMs is exceeded.
    std::function<void(double ms)> late;
    /// Called by a deferred journal when its base is on disk; from then on the journal contains the whole document.
    std::function<void()> begun;
};

/// The cost of a journal. Times in milliseconds.
struct JournalStats
{
    std::uint64_t records = 0, bytes = 0, compactions = 0;
    double packMs = 0, writeMs = 0; ///< sums over all records, measured on the writing thread
    double worstWrittenMs = 0;      ///< longest time from add() until the record survives the end of the process
    double worstSyncedMs = 0;       ///< longest time from add() until the record survives a power cut
    std::uint64_t late = 0;    ///< number of syncs that ended later than promisedMs after add() of their oldest record
    bool isCompacting = false; ///< a base is being made at this moment
};

/// Appends records to a journal's folder, with three threads of its own. The first writes added records at once, the
/// second syncs written records, and the third makes a new base when the log is long. Thread: all functions except the
/// constructor and the destructor may be called from any thread. All except drain() and flush() return at once.
class JournalWriter
{
public:
    struct Place
    {
        std::uint64_t nextRecord = 1;
        unsigned nextSegment = 0;
        bool waits = false; ///< true: records wait in memory until begin() has made the folder
    };

    /// Starts the threads, and syncs the start file in the background. Precondition: the folder has a start file,
    /// unless `place.waits`.
    JournalWriter(std::filesystem::path folder, Place place, JournalCallbacks callbacks, JournalLimits limits = {});
    /// Flushes like flush(), then ends the threads.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    void add(JournalRecord record);
    /// Runs `make` on the writing thread; it creates the folder and its start. Added records wait in memory until then.
    /// `make` may throw FileError and std::bad_alloc, which stop recording.
    void begin(std::function<void()> make);
    /// Calls `run` when all records added so far survive the end of the process, or recording has stopped. Calls are
    /// made in order, by the caller or the writing thread. If the journal waits for begin(), `run` is called
    /// immediately.
    void after(std::function<void()> run);
    /// Waits until all added records survive the end of the process, or recording has stopped. Records that wait for
    /// begin() do not count, here and in flush().
    void drain();
    /// Waits until all added records are synced, or recording has stopped.
    void flush();
    bool isBroken() const; ///< recording has stopped
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

    mutable std::mutex m_mutex; ///< guards all members from here to m_stats
    std::condition_variable m_wakeWriter, m_wakeSyncer, m_settled;
    std::deque<Entry> m_entries;
    std::size_t m_waitingBytes = 0;
    bool m_waits; ///< true until begin() has made the folder
    std::function<void()> m_make;
    bool m_isWriting = false, m_isEnding = false, m_isBroken = false, m_isCompacting = false;
    std::deque<std::shared_ptr<AppendFile>> m_unsynced;
    std::int64_t m_oldestUnsyncedNs = 0;
    bool m_isSyncing;                              ///< initially true: the start file is synced first
    std::map<unsigned, std::uintmax_t> m_segments; ///< sizes in bytes of the existing segments
    std::uintmax_t m_compactAt;                    ///< total size of the segments in bytes at which a new base is made
    JournalStats m_stats;

    std::uint64_t m_nextRecord; ///< used by the writing thread only, as is m_segment
    Segment m_segment;

    int m_consecutiveLate = 0; ///< used by the syncing thread only, as is m_isLateReported
    bool m_isLateReported = false;

    std::stop_source m_stop;
    std::thread m_compactor, m_syncer, m_writer;
};

/// Creates the start file of a journal without syncing it. JournalWriter can then use the folder. Throws FileError.
void writeStart(const std::filesystem::path& folder, const StartRecord& record);
} // namespace core
