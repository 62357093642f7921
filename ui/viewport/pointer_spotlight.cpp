#include "ui/viewport/pointer_spotlight.h"

#include <chrono>

namespace ui
{
namespace
{
constexpr std::chrono::seconds timeAtRest(4);

bool isSamePlace(const std::optional<core::SurfaceHit>& a, const std::optional<core::SurfaceHit>& b)
{
    return a.has_value() == b.has_value() && (!a || (a->position == b->position && a->normal == b->normal));
}
} // namespace

PointerSpotlight::PointerSpotlight(PointerInput* input, QObject* parent) : QObject(parent), m_input(input)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(timeAtRest);
    connect(&m_timer, &QTimer::timeout, this, &PointerSpotlight::report);
    connect(input, &PointerInput::hoverChanged, this, &PointerSpotlight::report);
}

void PointerSpotlight::setOn(bool on)
{
    if (on == isOn())
        return;
    m_input->finish();
    if (on)
        m_timer.start();
    m_input->setMode(PointerMode::Point, on);
}

void PointerSpotlight::restartTimer()
{
    if (isOn())
        m_timer.start();
}

void PointerSpotlight::report()
{
    const std::optional<core::SurfaceHit> place = m_timer.isActive() ? m_input->pointed() : std::nullopt;
    if (isSamePlace(place, m_place))
        return;
    m_place = place;
    Q_EMIT pointed(place);
}
} // namespace ui
