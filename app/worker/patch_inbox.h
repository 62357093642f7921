#pragma once

#include "core/mesh/mesh_patch.h"

#include <QObject>

#include <mutex>
#include <optional>

namespace app
{
/// Holds the changes that one viewer has not drawn yet. It has at most one patch; newer patches are merged into it. One
/// thread calls put(), another take(). Merging is done outside the lock, so neither waits for it.
class PatchInbox : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Adds a patch. Emits filled() if the viewer has called take() since the last filled().
    void put(core::MeshPatch patch);
    /// Returns the patch and removes it; nothing if the inbox is empty. Also returns nothing while put() is merging;
    /// filled() follows.
    std::optional<core::MeshPatch> take();

Q_SIGNALS:
    /// Emitted once per fill, on the thread that calls put(): use a queued connection.
    void filled();

private:
    std::mutex m_mutex;
    std::optional<core::MeshPatch> m_patch;
    bool m_announced = false;
};
} // namespace app
