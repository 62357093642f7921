#pragma once

#include "ui/scene/orbit_camera.h"

#include "core/mesh/footprint.h"
#include "core/mesh/surface_hit.h"

#include <QObject>

#include <memory>
#include <optional>

namespace ui
{
/// Queries where the surface is under a pixel, and keeps the newest answer. At most one request is in flight; of those
/// that wait only the newest is kept, but a press's is never displaced. Thread: gui.
class HoverQuery : public QObject
{
    Q_OBJECT

public:
    struct Request
    {
        OrbitCamera::Pixel pixel;
        core::Ray ray;
        bool isForPress = false;
        quint64 view = 0;  ///< m_view when it was made
        double turned = 0; ///< m_turned when it was made
    };

    using QObject::QObject;

    void request(const OrbitCamera::Pixel& pixel, const core::Ray& ray, bool isForPress = false);
    /// Takes the answer to the request in flight. Returns that request; nothing if there is none.
    std::optional<Request> takeAnswer(const std::optional<core::SurfaceHit>& hit,
                                      const std::shared_ptr<const core::Footprint>& footprint);
    /// Sends the request that waits, unless one is in flight.
    void sendNext();
    /// Drops the request that waits, unless it is a press's.
    void dropNext();

    /// The camera moved: answers to earlier requests are not of this view.
    void viewMoved();
    /// The model turned about the Y axis, in radians; in its own space the pointer goes the other way.
    void turnModel(double angle);
    /// The answers so far belong to another model.
    void clear();
    void clearFootprint() { m_footprint.reset(); }

    const std::optional<core::SurfaceHit>& hit() const { return m_hit; }
    /// What the brush would touch at the hit, if that was requested and the surface has not changed.
    const std::shared_ptr<const core::Footprint>& footprint() const { return m_footprint; }
    /// True if the answer is about this pixel in this view.
    bool isAbout(const OrbitCamera::Pixel& pixel) const { return m_answeredPixel == pixel; }

Q_SIGNALS:
    void sent(const Request& request);

private:
    void send(const Request& request);

    quint64 m_view = 0;  ///< grows when an older answer no longer fits
    double m_turned = 0; ///< of the model in the world, about Y; radians
    std::optional<Request> m_inFlight, m_next;
    std::optional<OrbitCamera::Pixel> m_answeredPixel; ///< none: the answer is not of this view, or there is none
    std::optional<core::SurfaceHit> m_hit;
    std::shared_ptr<const core::Footprint> m_footprint;
};
} // namespace ui
