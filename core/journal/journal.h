#pragma once

#include "core/journal/journal_folder.h"
#include "core/journal/journal_recovery.h"
#include "core/journal/journal_writer.h"

namespace core
{
/// The journal of one open document: every finished change goes to disk at once, in order, so that what ends the
/// program does not end the work. What is bounded: JournalLimits, beside the start and one base, two while a new one is
/// made.
class Journal
{
public:
    /// Of a model that was just opened. Any thread; takes writing the start. Throws FileError.
    static std::shared_ptr<Journal> begin(const std::filesystem::path& root, const StartRecord& start,
                                          JournalCallbacks callbacks, JournalLimits limits = {});
    /// Goes on where the folder's journal ended.
    static std::shared_ptr<Journal> resume(std::unique_ptr<JournalFolder> folder, const RecoveredDocument& document,
                                           JournalCallbacks callbacks, JournalLimits limits = {});
    /// Of a document with a history, in a hidden folder: beginWith() must follow. Any thread; what is recorded before
    /// waits for that.
    static std::shared_ptr<Journal> beginDeferred(std::shared_ptr<JournalFolder> folder, std::uint32_t present,
                                                  JournalCallbacks callbacks, JournalLimits limits = {});
    /// Writes the document's present in the background; nobody waits. No mesh: there was no memory for it. Any thread,
    /// once.
    void beginWith(std::shared_ptr<const Mesh> mesh, StartRecord start, BaseRecord base);

    // --- the mesh thread; cost: a copy of what changed ---
    /// A step was done: `delta` takes it back.
    void changed(const Mesh& mesh, const MeshDelta& delta, JournalStep step);
    /// The delta of the step at `index` was swapped.
    void swapped(const Mesh& mesh, const MeshDelta& delta, std::uint32_t index);
    /// The steps cannot be undone any more; the mesh is what it is.
    void forget();

    // --- any thread: as the writer has them ---
    void saved(std::uint32_t index) { m_writer->add(SavedRecord{index}); }
    void describe(JournalDocument document) { m_writer->add(std::move(document)); }
    void after(std::function<void()> run) { m_writer->after(std::move(run)); }
    void drain() { m_writer->drain(); }
    void flush() { m_writer->flush(); }
    bool isBroken() const { return m_writer->isBroken(); } ///< nothing is recorded any more
    JournalStats stats() const { return m_writer->stats(); }
    const std::filesystem::path& folder() const { return m_folder->path(); }

    /// The folder goes. Not while others use the journal.
    void remove();

private:
    Journal(std::shared_ptr<JournalFolder> folder, JournalWriter::Place place, JournalCallbacks callbacks,
            JournalLimits limits, std::uint32_t present);

    std::shared_ptr<JournalFolder> m_folder;
    std::uint32_t m_present; ///< steps that are done; the mesh thread's
    std::unique_ptr<JournalWriter> m_writer;
};
} // namespace core
