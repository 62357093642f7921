#include "vr/input/haptics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vr
{
namespace
{
/// A pulse at full level and strength: amplitude 0 to 1, frequency in Hz, length in seconds.
struct PulseShape
{
    double amplitude, frequency, seconds;
};

// Pulses that are easy to tell apart: contacts are light and high, refusals long and low. Indexed by Sensation. The
// length of a texture pulse is computed in Haptics::texture().
constexpr std::array<PulseShape, sensationCount> pulseShapes{{
    {0.35, 180, 0.02}, // Contact
    {0.45, 120, 0},    // Texture
    {1.0, 90, 0.06},   // Fusion
    {0.8, 40, 0.18},   // Refusal
    {0.4, 220, 0.01},  // MenuStep
    {0.7, 160, 0.02},  // Hold
}};

/// Shortest time between contact pulses, seconds: a brush that grazes a surface does not rattle.
constexpr double contactPause = 0.15;
constexpr double eventPause = 0.25;    ///< seconds without an event after which the next one counts as new
constexpr double trainPeriod = 0.05;   ///< shortest time between texture pulses, seconds
constexpr double trainShare = 0.3;     ///< fraction of the time that texture pulses fill
constexpr double maxPulse = 0.1;       ///< longest texture pulse, seconds
constexpr double minTexture = 0.2;     ///< fraction of the texture's amplitude at the lightest pressure
constexpr double frameRoundOff = 1e-9; ///< tolerance for rounding errors in sums of frame times
constexpr int holdTicks = 4; ///< number of pulses while a button is held; the last one comes when the hold is complete

PulseShape pulseShapeOf(Sensation what)
{
    return pulseShapes[static_cast<std::size_t>(what)];
}

/// Returns whether an event happens and is not part of a series. Sets `from`, the time from which the next event is
/// new.
bool begins(bool happens, double& from, double time)
{
    return happens && time >= std::exchange(from, time + eventPause);
}

double tickOf(double hold)
{
    return std::floor(hold * holdTicks + frameRoundOff);
}
} // namespace

std::vector<HapticPulse> Haptics::step(double time, const std::array<HapticInput, sideCount>& hands)
{
    std::vector<HapticPulse> pulses;
    for (const Side side : {Side::Left, Side::Right}) {
        const HapticInput& input = hands[static_cast<std::size_t>(side)];
        std::optional<HapticPulse> pulse = event(side, input, time);
        if (!pulse)
            pulse = texture(side, input, time);
        if (pulse)
            pulses.push_back(*pulse);
    }
    return pulses;
}

std::optional<HapticPulse> Haptics::event(Side side, const HapticInput& input, double time)
{
    Hand& hand = at(side);
    const std::optional<Event> event = eventOf(hand, input, time);
    if (!event || levelOf(event->what) <= 0)
        return std::nullopt;
    const PulseShape feel = pulseShapeOf(event->what);
    hand.quietUntil = time + feel.seconds;
    return HapticPulse{side, feel.amplitude * event->strength * levelOf(event->what), feel.frequency, feel.seconds};
}

/// Returns the most important event. Contacts and holds are tracked even if another event is more important.
std::optional<Haptics::Event> Haptics::eventOf(Hand& hand, const HapticInput& input, double time)
{
    const bool touched = std::exchange(hand.touched, input.touches);
    const bool isContact = input.touches && !touched && time >= hand.contactFrom;
    if (isContact)
        hand.contactFrom = time + contactPause;
    const double tick = tickOf(input.hold);
    const bool isTick = tick > tickOf(std::exchange(hand.hold, input.hold));
    const bool isRefusal = begins(input.refused, hand.refusalFrom, time);
    const bool isFusion = begins(input.fused, hand.fusionFrom, time);
    if (isRefusal)
        return Event{Sensation::Refusal, 1};
    if (isFusion)
        return Event{Sensation::Fusion, 1};
    if (isTick)
        return Event{Sensation::Hold, tick / holdTicks};
    if (input.stepped)
        return Event{Sensation::MenuStep, 1};
    if (isContact)
        return Event{Sensation::Contact, 1};
    return std::nullopt;
}

/// Returns the next pulse of the texture. It lasts for a fixed share of the time since the last pulse, so that the
/// texture feels the same at any frame rate.
std::optional<HapticPulse> Haptics::texture(Side side, const HapticInput& input, double time)
{
    Hand& hand = at(side);
    const double level = levelOf(Sensation::Texture);
    if (!input.touches || input.pressure <= 0 || level <= 0) {
        hand.trainAt.reset();
        return std::nullopt;
    }
    const double since = hand.trainAt ? time - *hand.trainAt : trainPeriod;
    if (since < trainPeriod - frameRoundOff || time < hand.quietUntil)
        return std::nullopt;
    hand.trainAt = time;
    const PulseShape feel = pulseShapeOf(Sensation::Texture);
    const double strength = minTexture + (1 - minTexture) * input.pressure;
    return HapticPulse{side, feel.amplitude * strength * level, feel.frequency, std::min(trainShare * since, maxPulse)};
}
} // namespace vr
