#include "app/worker/patch_inbox.h"

#include <utility>

namespace app
{
void PatchInbox::put(core::MeshPatch patch)
{
    std::optional<core::MeshPatch> older;
    if (!patch.whole) {
        const std::lock_guard lock(m_mutex);
        older = std::exchange(m_patch, std::nullopt);
    }
    if (older)
        older->merge(std::move(patch));
    else
        older = std::move(patch);

    bool announce = false;
    {
        const std::lock_guard lock(m_mutex);
        std::swap(m_patch, older); // an outdated patch is freed after the lock is released
        announce = !std::exchange(m_announced, true);
    }
    if (announce)
        Q_EMIT filled();
}

std::optional<core::MeshPatch> PatchInbox::take()
{
    const std::lock_guard lock(m_mutex);
    m_announced = false;
    return std::exchange(m_patch, std::nullopt);
}
} // namespace app
