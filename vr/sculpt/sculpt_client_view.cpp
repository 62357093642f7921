// What is seen in the headset, and at the window of who wears it.
#include "vr/sculpt/sculpt_client.h"

#include <cmath>

namespace vr
{
namespace
{
constexpr double measuresEvery = 0.5; ///< seconds; numbers that change faster cannot be read
constexpr double stillPulse = 0.4;
constexpr double pulseSeconds = 1.2; ///< of the light where somebody points: it catches the eye and does not flicker

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
            m_update.canUndo,
            m_update.canRedo,
            !m_update.isBusy,
            m_panels.isOpen(PanelKind::Files),
            m_panels.isOpen(PanelKind::Settings)};
}

void SculptClient::showPanels(const FrameInput& input)
{
    const double time = input.seconds();
    m_panels.open(PanelKind::Performance, m_settings.showsPerformance);
    if (m_panels.isOpen(PanelKind::Tools))
        m_panels.show(toolPanel());
    if (m_panels.isOpen(PanelKind::Color))
        m_panels.show(ColorPanel{m_brush.state().stroke.color, m_mapping.channel(), m_update.swatches});
    if (m_panels.isOpen(PanelKind::Files))
        m_panels.show(m_files);
    if (m_panels.isOpen(PanelKind::Settings))
        m_panels.show(SettingsPanel::of(m_settings, m_page));
    if (m_settings.showsPerformance) {
        if (std::abs(time - m_measuredAt) >= measuresEvery) {
            m_performance = PerformancePanel::of(input.timings.recent(), input.timings.droppedFrames());
            m_measuredAt = time;
        }
        m_panels.show(m_performance);
    }
    showLesson();
    showNotice(time);
}

/// Files stand in its place while they are open.
void SculptClient::showLesson()
{
    const bool isShown = m_update.lesson && !m_panels.isOpen(PanelKind::Files);
    m_panels.open(PanelKind::Lesson, isShown);
    if (!isShown)
        return;
    LessonPanel panel = *m_update.lesson;
    panel.page = m_lessonPage;
    m_panels.show(panel);
}

void SculptClient::showNotice(double time)
{
    if (m_update.noticeCount != m_noticeCount) {
        m_noticeCount = m_update.noticeCount;
        m_notice.text = m_update.notice;
        m_noticedAt = time;
        m_panels.open(PanelKind::Notice, false); // it appears where the person looks now
        m_panels.open(PanelKind::Notice);
    }
    if (!m_panels.isOpen(PanelKind::Notice))
        return;
    const double opacity = noticeOpacity(m_notice, time - m_noticedAt);
    m_panels.show(m_notice, static_cast<float>(opacity));
    if (time > m_noticedAt && opacity == 0)
        m_panels.open(PanelKind::Notice, false);
}

ShownWand SculptClient::shown(const WandState& wand, Side side) const
{
    ShownWand shown;
    shown.isShown = wand.isTracked;
    shown.grip = wand.grip;
    const auto light = [&](WandPart part, bool isLit) { shown.isLit[static_cast<std::size_t>(part)] = isLit; };
    const WandGestures& gestures = m_mapping.gestures(side);
    if (gestures.pad.held)
        light(partOf(*gestures.pad.held), true);
    light(WandPart::Trigger, gestures.trigger.isDown);
    light(WandPart::Menu, wand.menu);
    light(WandPart::Side, wand.side);
    shown.trigger = wand.trigger;
    if (wand.padTouched)
        shown.touch = wand.pad;
    if (const std::optional<WandMapping::Hold> hold = m_mapping.hold(side))
        shown.hold = hold->progress;
    shown.labels = m_labels.labels(side);
    const BrushState& brush = m_brush.state();
    if (side == m_settings.wands.sculpting && brush.stroke.tool == core::Tool::Paint)
        shown.tip = brush.stroke.color;
    return shown;
}

void SculptClient::updateScene(const FrameInput& input)
{
    const BrushState& brush = m_brush.state();
    m_state.head = m_head;
    m_state.model = m_placement.matrix();
    m_state.box = m_update.box;
    m_state.shading = m_update.shading;
    m_state.isFlat = m_update.isFlat;
    m_state.symmetry = brush.stroke.symmetry;
    m_state.radial = brush.stroke.radial;
    m_state.hasFloor = m_settings.showsFloor;
    m_state.brush = {};
    if (!pointsAtPanel(m_settings.wands.sculpting))
        m_state.brush = m_brush.shown(m_placement);
    m_state.brushColor = brush.stroke.tool == core::Tool::Paint ? brush.stroke.color : SceneState().brushColor;
    for (std::size_t i = 0; i < sideCount; ++i)
        m_state.wands[i] = shown(input.wands[i], static_cast<Side>(i));
    m_state.spotlight = {};
    if (m_update.pointed)
        m_state.spotlight = Spotlight{
            m_placement.toRoom(m_update.pointed->position), m_placement.directionToRoom(m_update.pointed->normal),
            m_update.reducesMotion ? stillPulse : std::fmod(std::abs(input.seconds()), pulseSeconds) / pulseSeconds};
    m_state.teacher = {};
    if (m_update.teacher)
        m_state.teacher = core::Sphere{m_placement.toRoom(m_update.teacher->center),
                                       m_placement.lengthToRoom(m_update.teacher->radius)};
    m_panels.list(m_state.panels);
    m_state.lasers = {};
    for (const Side side : {Side::Left, Side::Right})
        if (pointsAtPanel(side))
            m_state.lasers[static_cast<std::size_t>(side)] =
                Laser{tipOf(input.wands[static_cast<std::size_t>(side)]).position, m_panels.spot(side)->point};
    if (m_brush.footprint() != m_tint) {
        m_tint = m_brush.footprint();
        m_scene.tint(m_tint.get());
    }
}

void SculptClient::publishAvatar(const FrameInput& input)
{
    AvatarState avatar;
    avatar.head = input.head;
    for (std::size_t i = 0; i < sideCount; ++i)
        if (input.wands[i].isTracked)
            avatar.hands[i] = input.wands[i].grip;
    if (const auto* ball = std::get_if<BallBrush>(&m_state.brush))
        avatar.brush = core::Sphere{ball->center, ball->radius};
    avatar.radius = m_brush.state().radius;
    avatar.model = m_placement.matrix();
    m_port->show(avatar);
}
} // namespace vr
