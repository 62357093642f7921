#include "vr/scene/wand_labels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace vr
{
namespace
{
constexpr Side sides[] = {Side::Left, Side::Right};

WandSpot spotOf(Gesture gesture)
{
    switch (gesture) {
    case Gesture::Trigger:
        return WandSpot::Trigger;
    case Gesture::PadLeft:
        return WandSpot::PadLeft;
    case Gesture::PadRight:
        return WandSpot::PadRight;
    case Gesture::PadTop:
        return WandSpot::PadUp;
    case Gesture::PadBottom:
        return WandSpot::PadDown;
    case Gesture::Slide:
    case Gesture::SlideUpDown:
        return WandSpot::PadMiddle;
    case Gesture::Menu:
    case Gesture::MenuTap:
    case Gesture::MenuHold:
        return WandSpot::Menu;
    case Gesture::Squeeze:
    case Gesture::SqueezeHold:
        return WandSpot::Side;
    }
    return WandSpot::PadMiddle;
}

bool isOnSimpleWand(WandSpot spot)
{
    return spot == WandSpot::Trigger || spot == WandSpot::Menu;
}

constexpr std::size_t maxPresetRows = 32;

/// Returns the bit of a row of the preset.
std::uint64_t bitOf(std::size_t row)
{
    return std::uint64_t(1) << row;
}

/// Returns the bit of a row of a task.
std::uint64_t bitOf(HandTask task, std::size_t row)
{
    return bitOf(maxPresetRows + static_cast<std::size_t>(task) * maxTaskRows + row);
}

/// Bit of the first row for bare hands, after those of the five tasks.
constexpr std::size_t firstHandRow = maxPresetRows + 5 * maxTaskRows;
static_assert(firstHandRow + maxHandRows <= 64);

/// Rows in effect for a hand.
struct RowQuery
{
    ButtonPreset preset;
    HandTask task;
    bool isBare; ///< the hand holds no wand
};

/// Visits the rows in effect, each with its bit.
template <class Visit> void forEachRow(const RowQuery& query, Visit visit)
{
    const auto [preset, task, isBare] = query;
    const std::span<const PresetRow> rows = isBare ? handRows(preset) : presetRows(preset), ofTask = taskRows(task);
    assert(rows.size() <= (isBare ? maxHandRows : maxPresetRows) && ofTask.size() <= maxTaskRows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!isReplaced(rows[i], task))
            visit(rows[i], bitOf(isBare ? firstHandRow + i : i));
    for (std::size_t i = 0; i < ofTask.size(); ++i)
        visit(ofTask[i], bitOf(task, i));
}

bool isIn(const PresetRow& row, HandMode mode)
{
    return row.mode == HandMode::Any || row.mode == mode;
}

/// Returns whether the action executes the function of a preset's row. Presses of panels and refusals do not.
bool isOfRow(const WandAction& action)
{
    return !std::holds_alternative<PressPanel>(action) && !std::holds_alternative<ReleasePanel>(action) &&
           !std::holds_alternative<Refuse>(action);
}

bool opensPanel(const WandAction& action)
{
    return std::holds_alternative<OpenToolMenu>(action) || std::holds_alternative<OpenColorPanel>(action);
}

/// Returns whether both hands take part in the action by the same gesture.
bool isOfBothHands(const WandAction& action)
{
    const auto* stroke = std::get_if<BeginStroke>(&action);
    return std::holds_alternative<StretchModel>(action) || (stroke && stroke->smooths);
}

constexpr double degrees = 180 / std::numbers::pi;

/// Returns the angle between the direction of view and the wand's buttons, degrees.
double angleTo(const WandState& wand, const Pose& head)
{
    const core::Vec3 to = wand.grip * placeOf(WandSpot::PadMiddle) - head.position;
    return std::atan2(head.forward().cross(to).norm(), head.forward().dot(to)) * degrees;
}

/// Direction and distance from the head to the wand's buttons.
struct Bearing
{
    double aside, above; ///< degrees to the right and upward
    double distance;     ///< metres
};

Bearing bearingOf(const WandState& wand, const Pose& head)
{
    const core::Vec3 to = head.inverse() * (wand.grip * placeOf(WandSpot::PadMiddle));
    return {std::atan2(to.x(), -to.z()) * degrees, std::atan2(to.y(), std::hypot(to.x(), to.z())) * degrees, to.norm()};
}

constexpr double unseenAngle = 180; ///< angle of a wand that cannot be looked at, degrees

float approached(float opacity, bool isWanted, double seconds)
{
    const double by = isWanted ? seconds / labelFadeIn : -seconds / labelFadeOut;
    return std::clamp(opacity + static_cast<float>(by), 0.0F, 1.0F);
}
} // namespace

void WandLabels::step(const InputFrame& frame, const Pose& head, const WandMapping& hands,
                      std::span<const WandCommand> commands)
{
    const double seconds = m_clock.step(frame.time);
    if (m_settings != hands.settings())
        begin(hands);
    updateTask(hands);
    updateKinds(frame, hands);
    note(hands, commands);
    m_behind = behind(frame, head);
    for (const Side side : sides) {
        const WandState& wand = frame.wands[static_cast<std::size_t>(side)];
        const bool canBeLookedAt = wand.isTracked && !hands.isDrawing(side);
        const bool isLookedAt = at(side).look(canBeLookedAt ? angleTo(wand, head) : unseenAngle, seconds);
        if (frame.pointsAtPanel[static_cast<std::size_t>(side)] || m_behind == side)
            hide(at(side), seconds);
        else
            fade(at(side), isLookedAt, seconds);
    }
}

std::array<WandLabel, wandSpotCount> WandLabels::labels(Side side) const
{
    const Hand& hand = at(side);
    std::array<WandLabel, wandSpotCount> result;
    for (std::size_t spot = 0; spot < wandSpotCount; ++spot)
        result[spot] = {hand.lines()[spot].text, hand.opacities[spot]};
    return result;
}

void WandLabels::begin(const WandMapping& hands)
{
    m_settings = hands.settings();
    m_task = hands.task();
    m_used = 0;
    m_hands = {};
    for (const Side side : sides) {
        write(at(side), hands.roleOf(side));
        at(side).mode = hands.modeOf(side);
    }
}

void WandLabels::write(Hand& hand, HandRole role) const
{
    hand.linesOf = {};
    for (const HandMode mode : {HandMode::Plain, HandMode::ToolMenu, HandMode::ColorPanel})
        forEachRow({m_settings->preset, m_task, hand.kind.isHand}, [&](const PresetRow& row, std::uint64_t bit) {
            const WandSpot spot = spotOf(row.gesture);
            if (row.hand != role || !isIn(row, mode) || (hand.kind.isSimple && !isOnSimpleWand(spot)))
                return;
            Line& line = hand.linesOf[static_cast<std::size_t>(mode)][static_cast<std::size_t>(spot)];
            const QString label = labelOf(row, hand.kind.isStick);
            line.text += line.text.isEmpty() ? label : QStringLiteral(" \u00B7 ") + label;
            line.rows |= bit;
        });
}

/// Writes the labels again if the sculpting hand has another task. Labels with another text fade in from 0.
void WandLabels::updateTask(const WandMapping& hands)
{
    if (std::exchange(m_task, hands.task()) == hands.task())
        return;
    for (const Side side : sides) {
        const Lines before = at(side).lines();
        write(at(side), hands.roleOf(side));
        at(side).restart(before);
    }
}

/// Writes a hand's labels again if its wand is now of another kind.
void WandLabels::updateKinds(const InputFrame& frame, const WandMapping& hands)
{
    for (const Side side : sides) {
        const WandState& wand = frame.wands[static_cast<std::size_t>(side)];
        const WandKind kind{wand.isStick, wand.isSimple, wand.isHand};
        if (std::exchange(at(side).kind, kind) != kind)
            write(at(side), hands.roleOf(side));
    }
}

/// Marks the functions of the commands as used. Commands before the opening or closing of a panel in the same frame
/// belong to the mode before it.
void WandLabels::note(const WandMapping& hands, std::span<const WandCommand> commands)
{
    for (const WandCommand& command : commands) {
        if (!isOfRow(command.action))
            continue;
        for (const Side side : sides)
            if (side == command.side || isOfBothHands(command.action))
                use(hands, side, command.gesture);
        if (opensPanel(command.action))
            setMode(at(command.side), hands.modeOf(command.side));
    }
    for (const Side side : sides)
        setMode(at(side), hands.modeOf(side));
}

void WandLabels::use(const WandMapping& hands, Side side, Gesture gesture)
{
    const bool isBare = at(side).kind.isHand;
    forEachRow({m_settings->preset, m_task, isBare}, [&](const PresetRow& row, std::uint64_t bit) {
        if (row.hand == hands.roleOf(side) && row.gesture == gesture && isIn(row, at(side).mode))
            m_used |= bit;
    });
}

/// Updates how long the wand has been looked at. Returns whether that is long enough to show its labels.
bool WandLabels::Hand::look(double degrees, double seconds)
{
    const bool wasNear = isNear;
    isNear = degrees < (wasNear ? labelLookAwayAngle : labelLookAngle);
    nearFor = isNear && wasNear ? nearFor + seconds : 0;
    return isNear && nearFor >= labelLookSeconds;
}

bool WandLabels::Hand::isSeen() const
{
    return std::ranges::any_of(opacities, [](float opacity) { return opacity > 0; });
}

/// Returns the farther of two wands that are close to each other, if the nearer one shows labels; else none.
std::optional<Side> WandLabels::behind(const InputFrame& frame, const Pose& head) const
{
    const auto& [left, right] = frame.wands;
    if (!left.isTracked || !right.isTracked)
        return std::nullopt;
    const Bearing a = bearingOf(left, head), b = bearingOf(right, head);
    const double slack = m_behind ? labelGapSlack : 0;
    if (std::abs(a.aside - b.aside) > minLabelGapAside + slack ||
        std::abs(a.above - b.above) > minLabelGapAbove + slack)
        return std::nullopt;
    const double metres = !m_behind ? 0 : *m_behind == Side::Left ? labelGapSlackMetres : -labelGapSlackMetres;
    const bool isLeftFarther = a.distance + metres > b.distance;
    if (!at(isLeftFarther ? Side::Right : Side::Left).isSeen())
        return std::nullopt;
    return isLeftFarther ? Side::Left : Side::Right;
}

void WandLabels::fade(Hand& hand, bool isLookedAt, double seconds)
{
    for (std::size_t spot = 0; spot < wandSpotCount; ++spot) {
        const bool isNew = (hand.lines()[spot].rows & ~m_used) != 0;
        hand.opacities[spot] = approached(hand.opacities[spot], isNew || isLookedAt, seconds);
    }
}

/// Fades the labels out as fast as labels fade in, so that they do not hide a panel.
void WandLabels::hide(Hand& hand, double seconds)
{
    for (float& opacity : hand.opacities)
        opacity = std::max(opacity - static_cast<float>(seconds / labelFadeIn), 0.0F);
}

/// Sets the mode. Labels with another text fade in from 0.
void WandLabels::setMode(Hand& hand, HandMode mode)
{
    const HandMode before = std::exchange(hand.mode, mode);
    hand.restart(hand.linesOf[static_cast<std::size_t>(before)]);
}

/// Makes labels whose functions differ from those of `before` fade in from 0.
void WandLabels::Hand::restart(const Lines& before)
{
    for (std::size_t spot = 0; spot < wandSpotCount; ++spot)
        if (lines()[spot].rows != before[spot].rows)
            opacities[spot] = 0;
}
} // namespace vr
