#include "ui/input/hover_query.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace ui
{
namespace
{
/// Returns the material point that the model's turn by `angle` (radians, about Y) moved to `hit`.
core::SurfaceHit turnedBack(core::SurfaceHit hit, double angle)
{
    const Eigen::AngleAxisd back(-angle, core::Vec3::UnitY());
    hit.position = back * hit.position;
    hit.normal = back * hit.normal;
    return hit;
}
} // namespace

void HoverQuery::request(const OrbitCamera::Pixel& pixel, const core::Ray& ray, bool isForPress)
{
    const Request made{pixel, ray, isForPress, m_view, m_turned};
    if (!m_inFlight)
        send(made);
    else if (!m_next || !m_next->isForPress || isForPress)
        m_next = made;
}

void HoverQuery::send(const Request& request)
{
    m_inFlight = request;
    Q_EMIT sent(request);
}

std::optional<HoverQuery::Request> HoverQuery::takeAnswer(const std::optional<core::SurfaceHit>& hit,
                                                          const std::shared_ptr<const core::Footprint>& footprint)
{
    const std::optional<Request> answered = std::exchange(m_inFlight, std::nullopt);
    if (!answered || answered->view != m_view)
        return answered;
    m_hit = hit;
    m_footprint = footprint;
    if (m_hit && m_turned != answered->turned)
        m_hit = turnedBack(*m_hit, m_turned - answered->turned);
    m_answeredPixel = answered->pixel;
    return answered;
}

/// Sends the waiting request, which then counts as a request of the present view.
void HoverQuery::sendNext()
{
    if (!m_next || m_inFlight)
        return;
    const Request next = *m_next;
    m_next.reset();
    request(next.pixel, next.ray, next.isForPress);
}

void HoverQuery::dropNext()
{
    if (m_next && !m_next->isForPress)
        m_next.reset();
}

void HoverQuery::viewMoved()
{
    ++m_view;
    m_answeredPixel.reset();
}

void HoverQuery::turnModel(double angle)
{
    m_turned = std::remainder(m_turned + angle, 2 * std::numbers::pi);
    if (m_hit)
        m_hit = turnedBack(*m_hit, angle);
}

void HoverQuery::clear()
{
    viewMoved();
    m_turned = 0;
    m_hit.reset();
    m_footprint.reset();
}
} // namespace ui
