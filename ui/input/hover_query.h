#pragma once

#include "ui/scene/orbit_camera.h"

#include "core/mesh/footprint.h"
#include "core/mesh/surface_hit.h"

#include <QObject>

#include <memory>
#include <optional>

namespace ui
{
/// Finds the surface under a pixel asynchronously and keeps the latest answer. At most one request is in flight and one
/// is waiting. A newer request replaces the waiting one, except that a press is replaced only by another press. Thread:
/// gui.
class HoverQuery : public QObject
{
    Q_OBJECT

public:
    struct Request
    {
        OrbitCamera::Pixel pixel;
        core::Ray ray;
        bool isForPress = false;
        quint64 view = 0;  ///< m_view at the time of the request
        double turned = 0; ///< m_turned at the time of the request
    };

    using QObject::QObject;

    void request(const OrbitCamera::Pixel& pixel, const core::Ray& ray, bool isForPress = false);
    /// Stores the answer to the request in flight. Returns that request; nullopt if there is none.
    std::optional<Request> takeAnswer(const std::optional<core::SurfaceHit>& hit,
                                      const std::shared_ptr<const core::Footprint>& footprint);
    /// Sends the waiting request unless another one is in flight.
    void sendNext();
    /// Drops the waiting request unless it is a press's.
    void dropNext();

    /// Invalidates the answers to earlier requests, because the camera has moved.
    void viewMoved();
    /// Updates the answer after the model has turned by `angle` radians about the Y axis while the pointer rested. In
    /// model space, the place under the pointer has then turned by -`angle`.
    void turnModel(double angle);
    /// Forgets all answers, because there is another model.
    void clear();
    void clearFootprint() { m_footprint.reset(); }

    const std::optional<core::SurfaceHit>& hit() const { return m_hit; }
    /// Returns the vertices under the brush at the hit; null if not requested, or if the surface has changed.
    const std::shared_ptr<const core::Footprint>& footprint() const { return m_footprint; }
    /// Returns true if the answer is for this pixel in the present view.
    bool isAbout(const OrbitCamera::Pixel& pixel) const { return m_answeredPixel == pixel; }

Q_SIGNALS:
    void sent(const Request& request);

private:
    void send(const Request& request);

    quint64 m_view = 0;  ///< incremented whenever earlier answers become invalid
    double m_turned = 0; ///< angle of the model in the world about Y, radians
    std::optional<Request> m_inFlight, m_next;
    std::optional<OrbitCamera::Pixel> m_answeredPixel; ///< pixel of the answer; nullopt: no answer for the present view
    std::optional<core::SurfaceHit> m_hit;
    std::shared_ptr<const core::Footprint> m_footprint;
};
} // namespace ui
