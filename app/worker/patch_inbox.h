#pragma once

#include "core/mesh/mesh_patch.h"

#include <QObject>

#include <mutex>
#include <optional>

namespace app
{
/// The place where one viewer finds what it must draw anew: at most one patch, newer ones merge into it. One thread
/// puts, one takes; neither waits for the other longer than a move, for merging is done outside the lock.
class PatchInbox : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Emits filled() if the viewer has taken since the last one.
    void put(core::MeshPatch patch);
    /// Nothing while the inbox is empty; also for the moment in which put() merges, then filled() follows.
    std::optional<core::MeshPatch> take();

Q_SIGNALS:
    /// Once per fill, on the thread that put: connect it queued.
    void filled();

private:
    std::mutex m_mutex;
    std::optional<core::MeshPatch> m_patch;
    bool m_announced = false;
};
} // namespace app
