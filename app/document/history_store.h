#pragma once

#include "core/mesh/mesh_delta.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>
#include <QTemporaryDir>

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
/// One finished change of the mesh, in memory or in a file. All but the constructor: mesh thread only.
class StoredDelta
{
public:
    explicit StoredDelta(std::shared_ptr<core::MeshDelta> delta);
    ~StoredDelta();

    /// Undoes it, or does it again. Null if its file cannot be read; the mesh is untouched then.
    std::shared_ptr<core::MeshDelta> swap(core::Sculptor& sculptor);
    /// Moves it from memory into a file of that folder. False if that is impossible; it stays in memory then.
    bool spill(const QString& folder);
    void drop();
    /// Nothing if its file cannot be read, or there is not enough memory.
    std::optional<core::MeshDelta> copy() const;
    std::size_t bytesInMemory() const;

private:
    bool load();

    std::shared_ptr<core::MeshDelta> m_delta; ///< null: in m_file, or dropped
    std::string m_file;
};

/// Keeps the deltas of the undo stack within a number of bytes: those farthest from the present are spilled to disk,
/// and if that is impossible they expire, from the far end on. Thread: gui; the deltas themselves are touched by jobs
/// that it posts to the mesh thread, in order with the strokes.
class HistoryStore : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t defaultCap = std::size_t(512) << 20;

    /// How a job reaches the mesh thread. Must keep order and never wait.
    using Post = std::function<void(std::function<void(core::Sculptor&)>)>;

    explicit HistoryStore(Post post, QObject* parent = nullptr);
    ~HistoryStore() override;

    void setCap(std::size_t bytes);
    /// The folder of the spilled deltas; by default a temporary one of our own.
    void setFolder(const QString& folder);

    /// The change made at `index` of the undo stack; what was undone there and after it is forgotten.
    void add(int index, std::shared_ptr<core::MeshDelta> delta);
    /// Undoes or redoes the change at `index`; where none is kept nothing happens.
    void swap(int index);
    /// The change at `index`, which has not expired; it outlives its place here.
    std::shared_ptr<StoredDelta> at(int index) const { return m_entries.at(static_cast<std::size_t>(index)).delta; }
    /// Hears of each of them, on the mesh thread. May be null.
    void setJournal(std::shared_ptr<core::Journal> journal);
    /// Begins with these, of which so many are done; those that are null cannot be gone past.
    void restore(const std::vector<std::shared_ptr<core::MeshDelta>>& deltas, int present);
    /// Forgets all, another model is there.
    void clear();

    /// Whether the change below, or above, the present `index` of the undo stack is still there.
    bool canUndo(int index) const { return index > m_first; }
    bool canRedo(int index) const { return index < m_end; }
    /// The range of steps that the undo stack can go to.
    int firstIndex() const { return m_first; }
    int lastIndex() const { return m_end; }
    std::size_t bytesInMemory() const;

Q_SIGNALS:
    /// canUndo() or canRedo() may answer otherwise now.
    void expired();
    /// bytesInMemory() is another.
    void bytesChanged();
    /// A spilled change could not be read back: the undo stack is of no use any more. The model is in order.
    void lost();

private:
    struct Entry
    {
        std::shared_ptr<StoredDelta> delta;
        std::size_t bytes = 0; ///< in memory, as far as the gui thread knows
    };
    struct MeshSide
    {
        bool broken = false; ///< a swap failed: those that follow would not fit the mesh
    };

    void enforceCap();
    int farthestInMemory() const;
    void spill(int position);
    void makeOwnFolder();
    void spillFailed(const std::shared_ptr<StoredDelta>& delta);
    void expire(int position);
    void noteBytes(const std::shared_ptr<StoredDelta>& delta, std::size_t bytes);

    Post m_post;
    ui::ThreadMailbox m_mailbox; ///< from the jobs
    std::shared_ptr<MeshSide> m_meshSide;
    std::shared_ptr<core::Journal> m_journal;
    std::unique_ptr<QTemporaryDir> m_ownFolder;
    QString m_folder;
    std::size_t m_cap = defaultCap;
    std::vector<Entry> m_entries; ///< by position in the undo stack
    int m_present = 0;
    int m_first = 0; ///< entries before it have expired
    int m_end = 0;   ///< entries from it on have expired, or do not exist
};
} // namespace app
