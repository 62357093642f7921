#include "vr/input/wand_mapping.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace vr
{
namespace
{
constexpr int channelCount = 3;

Side other(Side side)
{
    return side == Side::Left ? Side::Right : Side::Left;
}

std::size_t indexOf(Side side)
{
    return static_cast<std::size_t>(side);
}

Gesture gestureOf(Sector sector)
{
    switch (sector) {
    case Sector::Left:
        return Gesture::PadLeft;
    case Sector::Right:
        return Gesture::PadRight;
    case Sector::Top:
        return Gesture::PadTop;
    case Sector::Bottom:
        return Gesture::PadBottom;
    }
    return Gesture::PadTop;
}

/// Returns the action that a press triggers immediately and once; none for other functions.
std::optional<WandAction> actionOf(WandFunction function)
{
    switch (function) {
    case WandFunction::Undo:
        return Undo{};
    case WandFunction::Redo:
        return Redo{};
    case WandFunction::SaveModel:
        return SaveModel{};
    case WandFunction::RestoreModel:
        return RestoreModel{};
    case WandFunction::ToggleTopology:
        return ToggleTopology{};
    case WandFunction::ToggleBrushShape:
        return ToggleBrushShape{};
    case WandFunction::ToggleSymmetry:
        return ToggleSymmetry{};
    case WandFunction::ToggleInverse:
        return ToggleInverse{};
    case WandFunction::PreviousTool:
        return StepTool{-1};
    case WandFunction::NextTool:
        return StepTool{1};
    default:
        return std::nullopt;
    }
}

/// Returns whether the function affects the whole document. Such functions are refused while a stroke is open.
bool waitsForStroke(WandFunction function)
{
    return function == WandFunction::Undo || function == WandFunction::Redo || function == WandFunction::SaveModel ||
           function == WandFunction::RestoreModel;
}
} // namespace

Pose tipOf(const WandState& wand)
{
    if (wand.isHand)
        return {wand.aim.rotation, wand.pinch.position};
    return {wand.aim.rotation, wand.grip.position + tipReach * wand.aim.forward()};
}

std::vector<WandCommand> WandMapping::setSettings(const WandSettings& settings)
{
    std::vector<WandCommand> ended = releaseAll();
    m_settings = settings;
    return ended;
}

std::vector<WandCommand> WandMapping::step(const InputFrame& frame)
{
    const double seconds = m_clock.step(frame.time);
    for (const Side side : order()) {
        const WandState& wand = frame.wands[indexOf(side)];
        if (wand.isHand != at(side).isBare)
            releaseHand(side);
        at(side).isBare = wand.isHand;
        at(side).gestures = at(side).reader.read(wand, seconds);
    }
    endFinishedStroke(frame);
    for (const Side side : order())
        updateTrigger(side, frame);
    for (const Side side : order())
        isDrawing(side) ? at(side).reader.ignoreButtonsUntilReleased() : updateButtons(side, seconds);
    updateGrabs(frame);
    updateHeldPart(frame);
    updateStroke(frame);
    return std::exchange(m_commands, {});
}

std::vector<WandCommand> WandMapping::releaseAll()
{
    endStroke();
    releasePart();
    for (const Side side : order())
        releaseHand(side);
    return std::exchange(m_commands, {});
}

/// Ends what a hand does with its buttons, except an open stroke. Those that are down have no effect until they were
/// released.
void WandMapping::releaseHand(Side side)
{
    Hand& hand = at(side);
    if (hand.trigger == TriggerUse::Panel)
        addCommand(side, Gesture::Trigger, ReleasePanel{false});
    hand.reader.ignoreUntilReleased();
    hand.gestures = {};
    hand.trigger = TriggerUse::None;
}

HandRole WandMapping::roleOf(Side side) const
{
    return side == m_settings.sculpting ? HandRole::Sculpting : HandRole::Support;
}

HandMode WandMapping::modeOf(Side side) const
{
    if (roleOf(side) == HandRole::Support)
        return m_toolMenuOpen ? HandMode::ToolMenu : HandMode::Plain;
    if (m_colorPanelOpen)
        return HandMode::ColorPanel;
    return m_toolMenuOpen && m_settings.preset == ButtonPreset::OneHand ? HandMode::ToolMenu : HandMode::Plain;
}

std::optional<WandMapping::Hold> WandMapping::hold(Side side) const
{
    const WandGestures& gestures = at(side).gestures;
    if (gestures.side.hold > 0 && functionOf(side, Gesture::SqueezeHold))
        return Hold{Gesture::SqueezeHold, gestures.side.hold};
    if (gestures.menu.hold > 0 && functionOf(side, Gesture::MenuHold))
        return Hold{Gesture::MenuHold, gestures.menu.hold};
    return std::nullopt;
}

/// Returns the hands by role, the sculpting one first: the order of commands does not depend on which hand that is.
std::array<Side, sideCount> WandMapping::order() const
{
    return {m_settings.sculpting, other(m_settings.sculpting)};
}

std::optional<WandFunction> WandMapping::functionOf(Side side, Gesture gesture) const
{
    return vr::functionOf(m_settings.preset, {roleOf(side), modeOf(side), gesture, m_task, at(side).isBare});
}

void WandMapping::addCommand(Side side, Gesture gesture, const WandAction& action)
{
    m_commands.push_back({side, gesture, action});
}

void WandMapping::endStroke()
{
    if (m_stroke && m_stroke->isBegun)
        addCommand(m_stroke->side, Gesture::Trigger, EndStroke{});
    m_stroke.reset();
}

/// Ends the stroke if its trigger was released, or if its wand was not tracked for longer than maxTrackingGap.
void WandMapping::endFinishedStroke(const InputFrame& frame)
{
    if (!m_stroke)
        return;
    if (frame.wands[indexOf(m_stroke->side)].isTracked)
        m_stroke->seenAt = frame.time;
    const bool isLost = frame.time - m_stroke->seenAt > maxTrackingGap;
    if (isLost || !at(m_stroke->side).gestures.trigger.isDown)
        endStroke();
}

void WandMapping::updateTrigger(Side side, const InputFrame& frame)
{
    Hand& hand = at(side);
    if (hand.gestures.trigger.wentUp && hand.trigger == TriggerUse::Panel)
        addCommand(side, Gesture::Trigger, ReleasePanel{frame.wands[indexOf(side)].isActive});
    if (!hand.gestures.trigger.isDown)
        hand.trigger = TriggerUse::None;
    if (hand.gestures.trigger.wentDown)
        pressTrigger(side, frame);
}

void WandMapping::pressTrigger(Side side, const InputFrame& frame)
{
    const bool isOnPanel = frame.pointsAtPanel[indexOf(side)];
    at(side).trigger = isOnPanel ? TriggerUse::Panel : TriggerUse::Function;
    if (isOnPanel)
        return addCommand(side, Gesture::Trigger, PressPanel{});
    const std::optional<WandFunction> function = functionOf(side, Gesture::Trigger);
    if (function != WandFunction::Sculpt && function != WandFunction::UseTip)
        return;
    const WandState& wand = frame.wands[indexOf(side)];
    if (!wand.isTracked || m_stroke)
        addCommand(side, Gesture::Trigger, Refuse{});
    else if (function == WandFunction::UseTip)
        addCommand(side, Gesture::Trigger, UseTip{tipOf(wand)});
    else
        m_stroke = {side, frame.time};
}

void WandMapping::updateButtons(Side side, double seconds)
{
    const WandGestures& gestures = at(side).gestures;
    if (gestures.pad.pressed)
        press(side, gestureOf(*gestures.pad.pressed));
    else if (gestures.pad.held)
        holdButton(side, gestureOf(*gestures.pad.held), seconds);
    if (gestures.pad.slide != Eigen::Vector2d::Zero()) {
        slide(side, Gesture::Slide, gestures.pad.slide.sum());
        slide(side, Gesture::SlideUpDown, gestures.pad.slide.y());
    }
    if (gestures.menu.wentDown)
        press(side, Gesture::Menu);
    if (gestures.menu.wasTapped)
        press(side, Gesture::MenuTap);
    if (gestures.menu.holdDone)
        press(side, Gesture::MenuHold);
    if (gestures.side.holdDone)
        press(side, Gesture::SqueezeHold);
}

void WandMapping::press(Side side, Gesture gesture)
{
    const std::optional<WandFunction> function = functionOf(side, gesture);
    if (!function)
        return;
    if (m_stroke && waitsForStroke(*function))
        return addCommand(side, gesture, Refuse{});
    if (const std::optional<WandAction> action = actionOf(*function))
        return addCommand(side, gesture, *action);
    if (*function == WandFunction::ToggleToolMenu) {
        m_toolMenuOpen = !m_toolMenuOpen;
        addCommand(side, gesture, OpenToolMenu{m_toolMenuOpen});
    } else if (*function == WandFunction::ToggleColorPanel) {
        m_colorPanelOpen = !m_colorPanelOpen;
        addCommand(side, gesture, OpenColorPanel{m_colorPanelOpen});
    } else if (*function == WandFunction::PreviousChannel || *function == WandFunction::NextChannel) {
        const int by = *function == WandFunction::NextChannel ? 1 : channelCount - 1;
        m_channel = (m_channel + by) % channelCount;
        addCommand(side, gesture, SelectChannel{m_channel});
    }
}

void WandMapping::holdButton(Side side, Gesture gesture, double seconds)
{
    const std::optional<WandFunction> function = functionOf(side, gesture);
    const double angle = turnSpeed * std::numbers::pi / 180 * seconds;
    if (function == WandFunction::TurnClockwise)
        addCommand(side, gesture, TurnModel{-angle});
    else if (function == WandFunction::TurnAnticlockwise)
        addCommand(side, gesture, TurnModel{angle});
}

void WandMapping::slide(Side side, Gesture gesture, double by)
{
    const std::optional<WandFunction> function = functionOf(side, gesture);
    if (!function || by == 0)
        return;
    if (*function == WandFunction::ScaleModel)
        addCommand(side, gesture, ScaleModel{std::exp2(by / slidePerDoubling)});
    else if (*function == WandFunction::SetRadius)
        addCommand(side, gesture, ScaleRadius{std::exp2(by / slidePerDoubling)});
    else if (*function == WandFunction::SetChannel)
        changeChannel(side, gesture, by);
}

/// Changes the selected channel, 0 to 255, by whole numbers. The remainder below 1 is kept for the next frame.
void WandMapping::changeChannel(Side side, Gesture gesture, double by)
{
    m_channelRemainder += by * channelSlide;
    const int whole = static_cast<int>(m_channelRemainder);
    m_channelRemainder -= whole;
    if (whole != 0)
        addCommand(side, gesture, ChangeChannel{m_channel, whole});
}

bool WandMapping::usesTrigger(Side side, WandFunction function) const
{
    return at(side).trigger == TriggerUse::Function && functionOf(side, Gesture::Trigger) == function;
}

bool WandMapping::isGrabbing(Side side) const
{
    if (isDrawing(side))
        return false;
    const bool squeezes =
        at(side).gestures.side.isDown && functionOf(side, Gesture::Squeeze) == WandFunction::MoveModel;
    return squeezes || usesTrigger(side, WandFunction::MoveModel);
}

/// Moves the model by the movement of each grip since the last frame, if the hand grabbed and was tracked in both
/// frames.
void WandMapping::updateGrabs(const InputFrame& frame)
{
    std::array<std::optional<Pose>, sideCount> from, to;
    const std::array<Side, sideCount> sides = order();
    for (std::size_t i = 0; i < sideCount; ++i) {
        const WandState& wand = frame.wands[indexOf(sides[i])];
        if (isGrabbing(sides[i]) && wand.isTracked)
            to[i] = wand.grip;
        from[i] = std::exchange(at(sides[i]).grip, to[i]);
    }
    const auto gestureAt = [&](Side side) {
        return usesTrigger(side, WandFunction::MoveModel) ? Gesture::Trigger : Gesture::Squeeze;
    };
    const bool both = to[0] && to[1];
    if (both && from[0] && from[1])
        return addCommand(sides[0], gestureAt(sides[0]),
                          StretchModel{{from[0]->position, from[1]->position}, {to[0]->position, to[1]->position}});
    for (std::size_t i = 0; i < sideCount && !both; ++i)
        if (from[i] && to[i])
            addCommand(sides[i], gestureAt(sides[i]), MoveModel{*from[i], *to[i]});
}

/// Moves the active part by the movement of the sculpting hand since the last frame. A hand that is lost lets go.
void WandMapping::updateHeldPart(const InputFrame& frame)
{
    const Side side = m_settings.sculpting;
    const WandState& wand = frame.wands[indexOf(side)];
    const bool holds = !m_stroke && wand.isTracked && at(side).gestures.side.isDown &&
                       functionOf(side, Gesture::Squeeze) == WandFunction::MovePart;
    if (!holds)
        return releasePart();
    if (m_partGrip)
        addCommand(side, Gesture::Squeeze, MovePart{*m_partGrip, wand.grip});
    m_partGrip = wand.grip;
}

void WandMapping::releasePart()
{
    if (std::exchange(m_partGrip, std::nullopt))
        addCommand(m_settings.sculpting, Gesture::Squeeze, ReleasePart{});
}

void WandMapping::updateStroke(const InputFrame& frame)
{
    if (!m_stroke)
        return;
    const Side side = m_stroke->side;
    const WandState& wand = frame.wands[indexOf(side)];
    if (!wand.isTracked)
        return;
    const bool smooths = m_task == HandTask::Sculpt && usesTrigger(other(side), WandFunction::Smooth);
    if (m_stroke->isBegun && smooths != m_stroke->smooths) {
        addCommand(side, Gesture::Trigger, EndStroke{});
        m_stroke->isBegun = false;
        m_stroke->continues = true;
    }
    if (!m_stroke->isBegun)
        addCommand(side, Gesture::Trigger, BeginStroke{smooths, m_stroke->continues});
    m_stroke->isBegun = true;
    m_stroke->smooths = smooths;
    addCommand(side, Gesture::Trigger, StrokePoint{frame.time, tipOf(wand), at(side).gestures.pressure});
}
} // namespace vr
