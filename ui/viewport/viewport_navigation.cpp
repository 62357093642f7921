#include "ui/viewport/viewport_state.h"

namespace ui
{
namespace
{
constexpr int flightMs = 350;
constexpr double minPlaceShare = 0.04; ///< of the model's longest side, that a place is shown as at least
} // namespace

void Viewport::State::placeMark()
{
    scene->shade(shades);
    if (mark)
        scene->showMark(mark->point, mark->normal, mark->radius);
    else
        scene->hideMark();
}

void Viewport::prepareFlight()
{
    QVariantAnimation* flight = &m_state->flight;
    flight->setStartValue(0.0);
    flight->setEndValue(1.0);
    flight->setDuration(flightMs);
    flight->setEasingCurve(QEasingCurve::InOutCubic);
    connect(flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) {
        m_state->camera.setPose(OrbitCamera::between(m_state->from, m_state->to, share.toDouble()));
        m_state->input.viewMoved();
    });
}

void Viewport::setReducesMotion(bool reducesMotion)
{
    m_state->reducesMotion = reducesMotion;
    m_state->highlight->setReducesMotion(reducesMotion);
}

bool Viewport::reducesMotion() const
{
    return m_state->reducesMotion;
}

void Viewport::setShades(const std::shared_ptr<const core::Footprint>& shades)
{
    m_state->shades = shades;
    update();
}

void Viewport::flyTo(const core::Vec3& point, const core::Vec3& normal, double extent)
{
    State& s = *m_state;
    setFollowing(false);
    s.flight.stop();
    const double size = s.box.isEmpty() ? extent : s.box.sizes().maxCoeff();
    const double shown = std::clamp(extent, minPlaceShare * size, size);
    s.mark = State::Mark{point, normal, 0.5 * shown};
    s.camera.setPivot({});
    s.from = s.camera.pose();
    s.to = s.camera.facing(point, normal, shown);
    if (!s.reducesMotion)
        return s.flight.start();
    s.camera.setPose(s.to);
    s.input.viewMoved();
}

void Viewport::clearMark()
{
    m_state->flight.stop();
    m_state->mark.reset();
    update();
}
} // namespace ui
