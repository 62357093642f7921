#include "vr/panels/panel_images.h"

#include <algorithm>
#include <utility>

namespace vr
{
PanelImages::PanelImages()
{
    m_thread = std::thread([this] { run(); });
}

PanelImages::~PanelImages()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isStopping = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void PanelImages::show(const PanelContent& content, const PanelTouches& touches)
{
    std::optional<PaintRequest>& requested = m_requested[content.index()];
    if (requested && requested->content == content && requested->touches == touches)
        return;
    std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock)
        return;
    requested = PaintRequest{content, touches};
    m_pending[content.index()] = requested;
    lock.unlock();
    m_wake.notify_one();
}

std::optional<PanelImage> PanelImages::take(PanelKind kind)
{
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    return lock ? std::exchange(m_ready[static_cast<std::size_t>(kind)], std::nullopt) : std::nullopt;
}

bool PanelImages::hasWork() const
{
    return m_isStopping || std::ranges::any_of(m_pending, [](const auto& request) { return request.has_value(); });
}

void PanelImages::run()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return hasWork(); });
        if (m_isStopping)
            return;
        const PaintRequests requests = std::exchange(m_pending, {});
        lock.unlock();
        paintAll(requests);
        lock.lock();
    }
}

void PanelImages::paintAll(const PaintRequests& requests)
{
    for (std::size_t i = 0; i < requests.size(); ++i) {
        if (!requests[i])
            continue;
        auto layout = std::make_shared<const PanelLayout>(layoutOf(requests[i]->content));
        PanelImage picture{layout, paint(*layout, requests[i]->touches)};
        const std::lock_guard lock(m_mutex);
        m_ready[i] = std::move(picture);
    }
}
} // namespace vr
