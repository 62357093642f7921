#pragma once

#include "vr/panels/panel_content.h"
#include "vr/panels/panel_painter.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace vr
{
/// A panel as it was painted, and what is where on that picture.
struct PanelPicture
{
    std::shared_ptr<const PanelLayout> layout;
    QImage image; ///< premultiplied
};

/// Paints panels on a thread of its own, each when what it shows has changed. show() and take() belong to one thread, which they never let
/// wait: they cost a comparison and a copy of values.
class PanelPictures
{
public:
    PanelPictures();
    ~PanelPictures();

    /// What the panel of that kind shows from now on. May be called each frame; if the painter is just taking what was asked, this is not
    /// heard, and the next call is.
    void show(const PanelContent& content, const PanelTouches& touches = {});
    /// The newest, once.
    std::optional<PanelPicture> take(PanelKind kind);

private:
    struct Wish
    {
        PanelContent content;
        PanelTouches touches;
        bool operator==(const Wish&) const = default;
    };
    using Wishes = std::array<std::optional<Wish>, panelKindCount>;

    void run();
    bool isAwaited() const;
    void paintAll(const Wishes& wishes);

    Wishes m_asked;     ///< last; the caller's own
    std::mutex m_mutex; ///< of the next three
    Wishes m_waiting;
    std::array<std::optional<PanelPicture>, panelKindCount> m_ready;
    bool m_stops = false;
    std::condition_variable m_news;
    std::thread m_thread; ///< last: it uses the others
};
} // namespace vr
