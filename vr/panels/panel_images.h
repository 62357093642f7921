#pragma once

#include "vr/panels/panel_content.h"
#include "vr/panels/panel_painter.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace vr
{
/// A painted panel, with the layout of the items on the picture.
struct PanelImage
{
    std::shared_ptr<const PanelLayout> layout;
    QImage image; ///< premultiplied alpha
};

/// Paints panels on a thread of its own, each when its content has changed. Thread: show() and take() are called on one
/// thread and never block it. Cost of each call: a comparison and a copy of values.
class PanelImages
{
public:
    PanelImages();
    ~PanelImages();

    /// Sets the content of a panel. To be called each frame: a call has no effect if the painting thread has locked the
    /// requests at that moment.
    void show(const PanelContent& content, const PanelTouches& touches = {});
    /// Returns the newest picture of a panel; none if it was taken already, or if the painting thread has locked the
    /// pictures at that moment.
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

    PaintRequests m_requested; ///< last request for each panel; used only by the calling thread
    std::mutex m_mutex;        ///< guards the next three members
    PaintRequests m_pending;
    std::array<std::optional<PanelImage>, panelKindCount> m_ready;
    bool m_isStopping = false;
    std::condition_variable m_wake;
    std::thread m_thread; ///< declared last, because the thread uses the other members
};
} // namespace vr
