#include "vr/panels/panel_textures.h"

#include <algorithm>
#include <utility>

namespace vr
{
PanelPictures::PanelPictures()
{
    m_thread = std::thread([this] { run(); });
}

PanelPictures::~PanelPictures()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stops = true;
    }
    m_news.notify_one();
    m_thread.join();
}

void PanelPictures::show(const PanelContent& content, const PanelTouches& touches)
{
    std::optional<Wish>& asked = m_asked[content.index()];
    if (asked && asked->content == content && asked->touches == touches)
        return;
    std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock)
        return;
    asked = Wish{content, touches};
    m_waiting[content.index()] = asked;
    lock.unlock();
    m_news.notify_one();
}

std::optional<PanelPicture> PanelPictures::take(PanelKind kind)
{
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    return lock ? std::exchange(m_ready[static_cast<std::size_t>(kind)], std::nullopt) : std::nullopt;
}

bool PanelPictures::isAwaited() const
{
    return m_stops || std::ranges::any_of(m_waiting, [](const auto& wish) { return wish.has_value(); });
}

void PanelPictures::run()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_news.wait(lock, [this] { return isAwaited(); });
        if (m_stops)
            return;
        const Wishes wishes = std::exchange(m_waiting, {});
        lock.unlock();
        paintAll(wishes);
        lock.lock();
    }
}

void PanelPictures::paintAll(const Wishes& wishes)
{
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        if (!wishes[i])
            continue;
        auto layout = std::make_shared<const PanelLayout>(layoutOf(wishes[i]->content));
        PanelPicture picture{layout, paint(*layout, wishes[i]->touches)};
        const std::lock_guard lock(m_mutex);
        m_ready[i] = std::move(picture);
    }
}
} // namespace vr
