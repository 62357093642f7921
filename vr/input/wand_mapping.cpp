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

/// What a press does at once and once.
std::optional<Deed> deedOf(WandFunction function)
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

/// Of the document as a whole, which an open stroke still changes.
bool waitsForStroke(WandFunction function)
{
    return function == WandFunction::Undo || function == WandFunction::Redo || function == WandFunction::SaveModel ||
           function == WandFunction::RestoreModel;
}
} // namespace

Pose tipOf(const WandState& wand)
{
    return {wand.aim.rotation, wand.grip.position + tipReach * wand.aim.forward()};
}

std::vector<HandCommand> Hands::choose(const HandsChoice& choice)
{
    std::vector<HandCommand> ended = letGo();
    m_choice = choice;
    return ended;
}

std::vector<HandCommand> Hands::step(const HandsFrame& frame)
{
    const double seconds = m_clock.step(frame.time);
    for (const Side side : order())
        at(side).gestures = at(side).reader.read(frame.wands[indexOf(side)], seconds);
    endFinishedStroke(frame);
    for (const Side side : order())
        takeTrigger(side, frame);
    for (const Side side : order())
        draws(side) ? at(side).reader.disregardButtons() : takeButtons(side, seconds);
    takeGrabs(frame);
    takeStroke(frame);
    return std::exchange(m_commands, {});
}

std::vector<HandCommand> Hands::letGo()
{
    endStroke();
    for (const Side side : order()) {
        Hand& hand = at(side);
        if (hand.trigger == TriggerUse::Panel)
            want(side, Gesture::Trigger, ReleasePanel{false});
        hand.reader.disregard();
        hand.gestures = {};
        hand.trigger = TriggerUse::None;
    }
    return std::exchange(m_commands, {});
}

HandRole Hands::roleOf(Side side) const
{
    return side == m_choice.sculpting ? HandRole::Sculpting : HandRole::Support;
}

HandMode Hands::modeOf(Side side) const
{
    if (roleOf(side) == HandRole::Support)
        return m_toolMenuOpen ? HandMode::ToolMenu : HandMode::Plain;
    if (m_colorPanelOpen)
        return HandMode::ColorPanel;
    return m_toolMenuOpen && m_choice.preset == Preset::OneHand ? HandMode::ToolMenu : HandMode::Plain;
}

std::optional<Hands::Hold> Hands::hold(Side side) const
{
    const WandGestures& gestures = at(side).gestures;
    if (gestures.side.hold > 0 && functionOf(side, Gesture::SqueezeHold))
        return Hold{Gesture::SqueezeHold, gestures.side.hold};
    if (gestures.menu.hold > 0 && functionOf(side, Gesture::MenuHold))
        return Hold{Gesture::MenuHold, gestures.menu.hold};
    return std::nullopt;
}

/// By their roles, not by left and right: swapped hands do the same in the same order.
std::array<Side, sideCount> Hands::order() const
{
    return {m_choice.sculpting, other(m_choice.sculpting)};
}

std::optional<WandFunction> Hands::functionOf(Side side, Gesture gesture) const
{
    return vr::functionOf(m_choice.preset, {roleOf(side), modeOf(side), gesture});
}

void Hands::want(Side side, Gesture gesture, const Deed& deed)
{
    m_commands.push_back({side, gesture, deed});
}

void Hands::endStroke()
{
    if (m_stroke && m_stroke->isBegun)
        want(m_stroke->side, Gesture::Trigger, EndStroke{});
    m_stroke.reset();
}

/// Its trigger was let go, or its wand was not seen for long.
void Hands::endFinishedStroke(const HandsFrame& frame)
{
    if (!m_stroke)
        return;
    if (frame.wands[indexOf(m_stroke->side)].isTracked)
        m_stroke->seenAt = frame.time;
    const bool isLost = frame.time - m_stroke->seenAt > longestBlink;
    if (isLost || !at(m_stroke->side).gestures.trigger.isDown)
        endStroke();
}

void Hands::takeTrigger(Side side, const HandsFrame& frame)
{
    Hand& hand = at(side);
    if (hand.gestures.trigger.wentUp && hand.trigger == TriggerUse::Panel)
        want(side, Gesture::Trigger, ReleasePanel{frame.wands[indexOf(side)].isActive});
    if (!hand.gestures.trigger.isDown)
        hand.trigger = TriggerUse::None;
    if (hand.gestures.trigger.wentDown)
        pull(side, frame);
}

void Hands::pull(Side side, const HandsFrame& frame)
{
    const bool isPanels = frame.pointsAtPanel[indexOf(side)];
    at(side).trigger = isPanels ? TriggerUse::Panel : TriggerUse::Function;
    if (isPanels)
        return want(side, Gesture::Trigger, PressPanel{});
    if (functionOf(side, Gesture::Trigger) != WandFunction::Sculpt)
        return;
    if (frame.wands[indexOf(side)].isTracked && !m_stroke)
        m_stroke = {side, frame.time};
    else
        want(side, Gesture::Trigger, Refuse{});
}

void Hands::takeButtons(Side side, double seconds)
{
    const WandGestures& gestures = at(side).gestures;
    if (gestures.pad.pressed)
        press(side, gestureOf(*gestures.pad.pressed));
    else if (gestures.pad.held)
        keepPressing(side, gestureOf(*gestures.pad.held), seconds);
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

void Hands::press(Side side, Gesture gesture)
{
    const std::optional<WandFunction> function = functionOf(side, gesture);
    if (!function)
        return;
    if (m_stroke && waitsForStroke(*function))
        return want(side, gesture, Refuse{});
    if (const std::optional<Deed> deed = deedOf(*function))
        return want(side, gesture, *deed);
    if (*function == WandFunction::ToggleToolMenu) {
        m_toolMenuOpen = !m_toolMenuOpen;
        want(side, gesture, OpenToolMenu{m_toolMenuOpen});
    } else if (*function == WandFunction::ToggleColorPanel) {
        m_colorPanelOpen = !m_colorPanelOpen;
        want(side, gesture, OpenColorPanel{m_colorPanelOpen});
    } else if (*function == WandFunction::PreviousChannel || *function == WandFunction::NextChannel) {
        const int by = *function == WandFunction::NextChannel ? 1 : channelCount - 1;
        m_channel = (m_channel + by) % channelCount;
        want(side, gesture, SelectChannel{m_channel});
    }
}

void Hands::keepPressing(Side side, Gesture gesture, double seconds)
{
    const std::optional<WandFunction> function = functionOf(side, gesture);
    const double angle = turnSpeed * std::numbers::pi / 180 * seconds;
    if (function == WandFunction::TurnClockwise)
        want(side, gesture, TurnModel{-angle});
    else if (function == WandFunction::TurnAnticlockwise)
        want(side, gesture, TurnModel{angle});
}

void Hands::slide(Side side, Gesture gesture, double by)
{
    const std::optional<WandFunction> function = functionOf(side, gesture);
    if (!function || by == 0)
        return;
    if (*function == WandFunction::ScaleModel)
        want(side, gesture, ScaleModel{std::exp2(by / slideDoubles)});
    else if (*function == WandFunction::SetRadius)
        want(side, gesture, ScaleRadius{std::exp2(by / slideDoubles)});
    else if (*function == WandFunction::SetChannel)
        changeChannel(side, gesture, by);
}

/// What is less than one of 255 is kept for the next frame.
void Hands::changeChannel(Side side, Gesture gesture, double by)
{
    m_channelRest += by * channelSlide;
    const int whole = static_cast<int>(m_channelRest);
    m_channelRest -= whole;
    if (whole != 0)
        want(side, gesture, ChangeChannel{m_channel, whole});
}

bool Hands::usesTrigger(Side side, WandFunction function) const
{
    return at(side).trigger == TriggerUse::Function && functionOf(side, Gesture::Trigger) == function;
}

bool Hands::grabs(Side side) const
{
    if (draws(side))
        return false;
    const bool squeezes =
        at(side).gestures.side.isDown && functionOf(side, Gesture::Squeeze) == WandFunction::MoveModel;
    return squeezes || usesTrigger(side, WandFunction::MoveModel);
}

/// By the way that each grip went since the frame before, if it was there and grabbed already.
void Hands::takeGrabs(const HandsFrame& frame)
{
    std::array<std::optional<Pose>, sideCount> from, to;
    const std::array<Side, sideCount> sides = order();
    for (std::size_t i = 0; i < sideCount; ++i) {
        const WandState& wand = frame.wands[indexOf(sides[i])];
        if (grabs(sides[i]) && wand.isTracked)
            to[i] = wand.grip;
        from[i] = std::exchange(at(sides[i]).grip, to[i]);
    }
    const auto gestureAt = [&](Side side) {
        return usesTrigger(side, WandFunction::MoveModel) ? Gesture::Trigger : Gesture::Squeeze;
    };
    const bool both = to[0] && to[1];
    if (both && from[0] && from[1])
        return want(sides[0], gestureAt(sides[0]),
                    StretchModel{{from[0]->position, from[1]->position}, {to[0]->position, to[1]->position}});
    for (std::size_t i = 0; i < sideCount && !both; ++i)
        if (from[i] && to[i])
            want(sides[i], gestureAt(sides[i]), MoveModel{*from[i], *to[i]});
}

void Hands::takeStroke(const HandsFrame& frame)
{
    if (!m_stroke)
        return;
    const Side side = m_stroke->side;
    const WandState& wand = frame.wands[indexOf(side)];
    if (!wand.isTracked)
        return;
    const bool smooths = usesTrigger(other(side), WandFunction::Smooth);
    if (m_stroke->isBegun && smooths != m_stroke->smooths) {
        want(side, Gesture::Trigger, EndStroke{});
        m_stroke->isBegun = false;
        m_stroke->goesOn = true;
    }
    if (!m_stroke->isBegun)
        want(side, Gesture::Trigger, BeginStroke{smooths, m_stroke->goesOn});
    m_stroke->isBegun = true;
    m_stroke->smooths = smooths;
    want(side, Gesture::Trigger, StrokePoint{frame.time, tipOf(wand), at(side).gestures.pressure});
}
} // namespace vr
