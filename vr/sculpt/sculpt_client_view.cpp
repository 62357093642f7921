// What is seen in the headset, and at the window of who wears it.
#include "vr/sculpt/sculpt_client.h"

#include <cmath>

namespace vr
{
namespace
{
constexpr double measuresEvery = 0.5; ///< seconds; numbers that change faster cannot be read
constexpr double calmPulse = 0.4;
constexpr double pulseSeconds = 1.2;  ///< of the light where somebody points: it catches the eye and does not flicker

WandPart partOf(Sector sector)
{
    switch (sector) {
    case Sector::Left:
        return WandPart::PadLeft;
    case Sector::Right:
        return WandPart::PadRight;
    case Sector::Top:
        return WandPart::PadUp;
    case Sector::Bottom:
        return WandPart::PadDown;
    }
    return WandPart::PadMiddle;
}
} // namespace

ToolPanel SculptClient::toolPanel() const
{
    const BrushState& brush = m_brush.state();
    return {brush.stroke.tool,
            brush.stroke.brush,
            brush.stroke.topology,
            brush.stroke.symmetry != core::Symmetry::None,
            brush.stroke.radial,
            brush.isInverse,
            m_news.canUndo,
            m_news.canRedo,
            !m_news.isBusy,
            m_wall.isOpen(PanelKind::Files),
            m_wall.isOpen(PanelKind::Settings)};
}

void SculptClient::showPanels(const FrameInput& input)
{
    const double time = input.seconds();
    m_wall.open(PanelKind::Performance, m_choice.showsPerformance);
    if (m_wall.isOpen(PanelKind::Tools))
        m_wall.show(toolPanel());
    if (m_wall.isOpen(PanelKind::Color))
        m_wall.show(ColorPanel{m_brush.state().stroke.color, m_hands.channel(), m_news.swatches});
    if (m_wall.isOpen(PanelKind::Files))
        m_wall.show(m_files);
    if (m_wall.isOpen(PanelKind::Settings))
        m_wall.show(SettingsPanel::of(m_choice, m_page));
    if (m_choice.showsPerformance) {
        if (std::abs(time - m_measuredAt) >= measuresEvery) {
            m_performance = PerformancePanel::of(input.costs.last(), input.costs.lostFrames());
            m_measuredAt = time;
        }
        m_wall.show(m_performance);
    }
    showLesson();
    showNotice(time);
}

/// Files stand in its place while they are open.
void SculptClient::showLesson()
{
    const bool isShown = m_news.lesson && !m_wall.isOpen(PanelKind::Files);
    m_wall.open(PanelKind::Lesson, isShown);
    if (!isShown)
        return;
    LessonPanel panel = *m_news.lesson;
    panel.page = m_lessonPage;
    m_wall.show(panel);
}

void SculptClient::showNotice(double time)
{
    if (m_news.noticeCount != m_noticeCount) {
        m_noticeCount = m_news.noticeCount;
        m_notice.text = m_news.notice;
        m_noticedAt = time;
        m_wall.open(PanelKind::Notice, false); // it appears where the person looks now
        m_wall.open(PanelKind::Notice);
    }
    if (!m_wall.isOpen(PanelKind::Notice))
        return;
    const double opacity = noticeOpacity(m_notice, time - m_noticedAt);
    m_wall.show(m_notice, static_cast<float>(opacity));
    if (time > m_noticedAt && opacity == 0)
        m_wall.open(PanelKind::Notice, false);
}

ShownWand SculptClient::shown(const WandState& wand, Side side) const
{
    ShownWand shown;
    shown.isShown = wand.isTracked;
    shown.grip = wand.grip;
    const auto light = [&](WandPart part, bool isLit) { shown.isLit[static_cast<std::size_t>(part)] = isLit; };
    const WandGestures& gestures = m_hands.gestures(side);
    if (gestures.pad.held)
        light(partOf(*gestures.pad.held), true);
    light(WandPart::Trigger, gestures.trigger.isDown);
    light(WandPart::Menu, wand.menu);
    light(WandPart::Side, wand.side);
    shown.trigger = wand.trigger;
    if (wand.padTouched)
        shown.touch = wand.pad;
    if (const std::optional<Hands::Hold> hold = m_hands.hold(side))
        shown.hold = hold->progress;
    shown.labels = m_labels.labels(side);
    const BrushState& brush = m_brush.state();
    if (side == m_choice.hands.sculpting && brush.stroke.tool == core::Tool::Paint)
        shown.tip = brush.stroke.color;
    return shown;
}

void SculptClient::see(const FrameInput& input)
{
    const BrushState& brush = m_brush.state();
    m_state.head = m_head;
    m_state.model = m_room.matrix();
    m_state.box = m_news.box;
    m_state.shading = m_news.shading;
    m_state.isFlat = m_news.isFlat;
    m_state.symmetry = brush.stroke.symmetry;
    m_state.radial = brush.stroke.radial;
    m_state.hasFloor = m_choice.showsFloor;
    m_state.brush = {};
    if (!pointsAtPanel(m_choice.hands.sculpting))
        m_state.brush = m_brush.shown(m_room);
    m_state.brushColor = brush.stroke.tool == core::Tool::Paint ? brush.stroke.color : SceneState().brushColor;
    for (std::size_t i = 0; i < sideCount; ++i)
        m_state.wands[i] = shown(input.wands[i], static_cast<Side>(i));
    m_state.light = {};
    if (m_news.pointed)
        m_state.light = PointLight{m_room.toRoom(m_news.pointed->position), m_room.directionToRoom(m_news.pointed->normal),
                                   m_news.isCalm ? calmPulse : std::fmod(std::abs(input.seconds()), pulseSeconds) / pulseSeconds};
    m_state.teacher = {};
    if (m_news.teacher)
        m_state.teacher = core::Sphere{m_room.toRoom(m_news.teacher->center), m_room.lengthToRoom(m_news.teacher->radius)};
    m_wall.list(m_state.panels);
    m_state.lasers = {};
    for (const Side side : {Side::Left, Side::Right})
        if (pointsAtPanel(side))
            m_state.lasers[static_cast<std::size_t>(side)] =
                Laser{tipOf(input.wands[static_cast<std::size_t>(side)]).position, m_wall.spot(side)->point};
    if (m_brush.footprint() != m_tint) {
        m_tint = m_brush.footprint();
        m_scene.tint(m_tint.get());
    }
}

void SculptClient::tellPresence(const FrameInput& input)
{
    Presence presence;
    presence.head = input.head;
    for (std::size_t i = 0; i < sideCount; ++i)
        if (input.wands[i].isTracked)
            presence.hands[i] = input.wands[i].grip;
    if (const auto* ball = std::get_if<BallBrush>(&m_state.brush))
        presence.brush = core::Sphere{ball->center, ball->radius};
    presence.radius = m_brush.state().radius;
    presence.model = m_room.matrix();
    m_port->show(presence);
}
} // namespace vr
