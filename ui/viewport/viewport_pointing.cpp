#include "ui/viewport/viewport_state.h"

#include <chrono>

namespace ui
{
namespace
{
constexpr std::chrono::seconds shownAtRest(4);

bool isSamePlace(const std::optional<core::SurfaceHit>& a, const std::optional<core::SurfaceHit>& b)
{
    return a.has_value() == b.has_value() && (!a || (a->position == b->position && a->normal == b->normal));
}
} // namespace

void Viewport::State::placeLight()
{
    if (!pointed)
        return light->place({});
    const OrbitCamera::Pixel at = camera.project(pointed->position);
    light->place(QPointF(at.x(), at.y()));
}

void Viewport::preparePointing()
{
    m_state->pointRest.setSingleShot(true);
    m_state->pointRest.setInterval(shownAtRest);
    connect(&m_state->pointRest, &QTimer::timeout, this, &Viewport::tellPointed);
    connect(&m_state->input, &PointerInput::hoverChanged, this, &Viewport::tellPointed);
    connect(&m_state->input, &PointerInput::pointingChanged, this, &Viewport::pointingChanged);
}

/// The pointer moves.
void Viewport::wakePointing()
{
    if (m_state->input.isPointing())
        m_state->pointRest.start();
}

void Viewport::setPointing(bool on)
{
    if (on == isPointing())
        return;
    finish();
    if (on)
        m_state->pointRest.start();
    m_state->input.setPointing(on);
}

bool Viewport::isPointing() const
{
    return m_state->input.isPointing();
}

void Viewport::tellPointed()
{
    State& s = *m_state;
    const std::optional<core::SurfaceHit> place = s.pointRest.isActive() ? s.input.pointed() : std::nullopt;
    if (isSamePlace(place, s.pointed))
        return;
    s.pointed = place;
    update();
    Q_EMIT pointed(place);
}
} // namespace ui
