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
struct PanelImage
{
    std::shared_ptr<const PanelLayout> layout;
    QImage image; ///< premultiplied
};

/// Paints panels on a thread of its own, each when what it shows has changed. show() and take() belong to one thread,
/// which they never let wait: they cost a comparison and a copy of values.
class PanelImages
{
public:
    PanelImages();
    ~PanelImages();

    /// What the panel of that kind shows from now on. May be called each frame; if the painter is just taking what was
    /// asked, this is not heard, and the next call is.
    void show(const PanelContent& content, const PanelTouches& touches = {});
    /// The newest, once.
    std::optional<PanelImage> take(PanelKind kind);

private:
    struct PaintRequest
    {
        PanelContent content;
        PanelTouches touches;
        bool operator==(const PaintRequest&) const = default;
    };
    using PaintRequests = std::array<std::optional<PaintRequest>, panelKindCount>;

    void run();
    bool hasWork() const;
    void paintAll(const PaintRequests& requests);

    PaintRequests m_requested; ///< last; the caller's own
    std::mutex m_mutex;        ///< of the next three
    PaintRequests m_pending;
    std::array<std::optional<PanelImage>, panelKindCount> m_ready;
    bool m_isStopping = false;
    std::condition_variable m_wake;
    std::thread m_thread; ///< last: it uses the others
};
} // namespace vr
