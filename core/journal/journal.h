#pragma once

#include "core/journal/journal_folder.h"
#include "core/journal/journal_recovery.h"
#include "core/journal/journal_writer.h"

namespace core
{
/// The journal of one open document. It writes every finished change to disk at once and in order, so that a crash
/// loses no work. JournalLimits bounds the size of the segments. The start and one base (two while a new one is made)
/// are stored in addition.
class Journal
{
public:
    /// Begins the journal of a model that was just opened, and writes its start before returning. Throws FileError.
    /// Thread: any.
    static std::shared_ptr<Journal> begin(const std::filesystem::path& root, const StartRecord& start,
                                          JournalCallbacks callbacks, JournalLimits limits = {});
    /// Continues a recovered document's journal in its folder.
    static std::shared_ptr<Journal> resume(std::unique_ptr<JournalFolder> folder, const RecoveredDocument& document,
                                           JournalCallbacks callbacks, JournalLimits limits = {});
    /// Makes a journal for a document that already has a history, in a hidden folder. Records wait in memory until
    /// beginWith(), which must be called. Thread: any.
    static std::shared_ptr<Journal> beginDeferred(std::shared_ptr<JournalFolder> folder, std::uint32_t present,
                                                  JournalCallbacks callbacks, JournalLimits limits = {});
    /// Writes the document's current state in the background and then makes the folder visible. A null mesh means that
    /// there was no memory for the copy: recording stops. Thread: any; call it once.
    void beginWith(std::shared_ptr<const Mesh> mesh, StartRecord start, BaseRecord base);

    // --- the mesh thread; cost: a copy of the changed elements ---
    /// Records a new step. Swapping `delta` into the mesh undoes the step.
    void changed(const Mesh& mesh, const MeshDelta& delta, JournalStep step);
    /// Records that the step at `index` was undone or redone by swapping `delta`.
    void swapped(const Mesh& mesh, const MeshDelta& delta, std::uint32_t index);
    /// Records that the history was cleared: no step can be undone any more, and the mesh is unchanged.
    void forget();

    // --- any thread; each forwards to JournalWriter ---
    void saved(std::uint32_t index) { m_writer->add(SavedRecord{index}); }
    void describe(JournalDocument document) { m_writer->add(std::move(document)); }
    void after(std::function<void()> run) { m_writer->after(std::move(run)); }
    void drain() { m_writer->drain(); }
    void flush() { m_writer->flush(); }
    bool isBroken() const { return m_writer->isBroken(); } ///< recording has stopped
    JournalStats stats() const { return m_writer->stats(); }
    const std::filesystem::path& folder() const { return m_folder->path(); }

    /// Stops recording and removes the folder. Precondition: no other thread uses the journal.
    void remove();

private:
    Journal(std::shared_ptr<JournalFolder> folder, JournalWriter::Place place, JournalCallbacks callbacks,
            JournalLimits limits, std::uint32_t present);

    std::shared_ptr<JournalFolder> m_folder;
    std::uint32_t m_present; ///< number of steps that are done; used by the mesh thread only
    std::unique_ptr<JournalWriter> m_writer;
};
} // namespace core
