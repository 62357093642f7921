#include "ui/viewport/viewport_state.h"

#include <chrono>

namespace ui
{
namespace
{
constexpr std::chrono::seconds pointingTimeout(4);

bool isSamePlace(const std::optional<core::SurfaceHit>& a, const std::optional<core::SurfaceHit>& b)
{
    return a.has_value() == b.has_value() && (!a || (a->position == b->position && a->normal == b->normal));
}
} // namespace

void Viewport::State::placeHighlight()
{
    if (!pointed)
        return highlight->place({});
    const OrbitCamera::Pixel at = camera.project(pointed->position);
    highlight->place(QPointF(at.x(), at.y()));
}

void Viewport::preparePointing()
{
    m_state->pointingTimer.setSingleShot(true);
    m_state->pointingTimer.setInterval(pointingTimeout);
    connect(&m_state->pointingTimer, &QTimer::timeout, this, &Viewport::emitPointed);
    connect(&m_state->input, &PointerInput::hoverChanged, this, &Viewport::emitPointed);
    connect(&m_state->input, &PointerInput::pointingChanged, this, &Viewport::pointingChanged);
}

/// The pointer moves.
void Viewport::restartPointingTimer()
{
    if (m_state->input.isPointing())
        m_state->pointingTimer.start();
}

void Viewport::setPointing(bool on)
{
    if (on == isPointing())
        return;
    finish();
    if (on)
        m_state->pointingTimer.start();
    m_state->input.setPointing(on);
}

bool Viewport::isPointing() const
{
    return m_state->input.isPointing();
}

void Viewport::emitPointed()
{
    State& s = *m_state;
    const std::optional<core::SurfaceHit> place = s.pointingTimer.isActive() ? s.input.pointed() : std::nullopt;
    if (isSamePlace(place, s.pointed))
        return;
    s.pointed = place;
    update();
    Q_EMIT pointed(place);
}
} // namespace ui
