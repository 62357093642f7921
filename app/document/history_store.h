#pragma once

#include "core/mesh/mesh_delta.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>
#include <QTemporaryDir>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace core
{
class Journal;
class Sculptor;
} // namespace core

namespace app
{
/// A finished change of the mesh, stored in memory or in a file. Thread: mesh, except the constructor.
class StoredDelta
{
public:
    explicit StoredDelta(std::shared_ptr<core::MeshDelta> delta);
    ~StoredDelta();

    /// Undoes or redoes the change, and returns it. Returns null if its file cannot be read; the mesh is then
    /// unchanged.
    std::shared_ptr<core::MeshDelta> swap(core::Sculptor& sculptor);
    /// Moves the change from memory to a file in `folder`. Returns false if that fails; it then stays in memory.
    bool spill(const QString& folder);
    void drop();
    /// Returns a copy of the change; nothing if its file cannot be read or there is not enough memory.
    std::optional<core::MeshDelta> copy() const;
    std::size_t bytesInMemory() const;

private:
    bool load();
    void removeFile();

    std::shared_ptr<core::MeshDelta> m_delta; ///< null: the change is in m_file, or dropped
    std::filesystem::path m_file;             ///< empty: none
};

/// Keeps the deltas of the undo stack within a limit of memory. The deltas farthest from the present state are moved to
/// disk; if that fails they expire, with all deltas beyond them. Thread: gui; the deltas are accessed only by jobs
/// posted to the mesh thread, in order with the strokes.
class HistoryStore : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t defaultCap = std::size_t(512) << 20;

    /// Posts a job to the mesh thread. It must keep the order of jobs and must not block.
    using Post = std::function<void(std::function<void(core::Sculptor&)>)>;

    explicit HistoryStore(Post post, QObject* parent = nullptr);
    ~HistoryStore() override;

    void setCap(std::size_t bytes);
    /// Sets the folder for deltas moved to disk; the default is a temporary folder.
    void setFolder(const QString& folder);

    /// Stores the change of step `index`, and forgets the undone changes from `index` on.
    void add(int index, std::shared_ptr<core::MeshDelta> delta);
    /// Undoes or redoes the change at `index`. Does nothing if no such change was added. Precondition: it has not
    /// expired.
    void swap(int index);
    /// Returns the change at `index`. Precondition: it has not expired.
    std::shared_ptr<StoredDelta> at(int index) const { return m_entries.at(static_cast<std::size_t>(index)).delta; }
    /// Sets the journal that records each undo and redo, on the mesh thread. May be null.
    void setJournal(std::shared_ptr<core::Journal> journal);
    /// Replaces all changes by `deltas`, of which the first `present` are in effect. Null deltas cannot be undone or
    /// redone.
    void restore(const std::vector<std::shared_ptr<core::MeshDelta>>& deltas, int present);
    /// Forgets all changes, because another model is opened.
    void clear();

    /// Returns whether the change before (canUndo) or after (canRedo) undo state `index` is still stored.
    bool canUndo(int index) const { return index > m_first; }
    bool canRedo(int index) const { return index < m_end; }
    /// Returns the first and the last undo state that can be reached.
    int firstIndex() const { return m_first; }
    int lastIndex() const { return m_end; }
    std::size_t bytesInMemory() const;

Q_SIGNALS:
    /// Emitted when a change has expired, so that canUndo() or canRedo() may have changed.
    void expired();
    /// Emitted after an undo or redo, which may have changed bytesInMemory().
    void bytesChanged();
    /// Emitted when a change on disk could not be read: the undo stack is unusable now. The present model is intact.
    void lost();

private:
    struct Entry
    {
        std::shared_ptr<StoredDelta> delta;
        std::size_t bytes = 0; ///< bytes in memory, as known to the gui thread
    };
    struct MeshSide
    {
        bool broken = false; ///< an undo or redo failed, so further ones would not match the mesh
    };

    void enforceCap();
    int farthestInMemory() const;
    void spill(int position);
    void makeOwnFolder();
    void spillFailed(const std::shared_ptr<StoredDelta>& delta);
    void expire(int position);
    void noteBytes(const std::shared_ptr<StoredDelta>& delta, std::size_t bytes);

    Post m_post;
    ui::ThreadMailbox m_mailbox; ///< for messages from jobs on the mesh thread
    std::shared_ptr<MeshSide> m_meshSide;
    std::shared_ptr<core::Journal> m_journal;
    std::unique_ptr<QTemporaryDir> m_ownFolder;
    QString m_folder;
    std::size_t m_cap = defaultCap;
    std::vector<Entry> m_entries; ///< in the order of the undo stack
    int m_present = 0;
    int m_first = 0; ///< entries before this index have expired
    int m_end = 0;   ///< entries from this index on have expired or do not exist
};
} // namespace app
