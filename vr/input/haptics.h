#pragma once

#include "vr/openxr/haptic_pulse.h"

#include <optional>
#include <vector>

namespace vr
{
/// Kinds of vibration, by their cause.
enum class Sensation { Contact, Texture, Fusion, Refusal, MenuStep, Hold };
inline constexpr std::size_t sensationCount = 6;

/// Strength of each kind of vibration, 0 (off) to 1.
struct HapticLevels
{
    std::array<double, sensationCount> of{1, 1, 1, 1, 1, 1}; ///< indexed by Sensation

    bool operator==(const HapticLevels&) const = default;
};

/// Events of one hand in one frame.
struct HapticInput
{
    bool touches = false; ///< the hand's brush meets the surface
    double pressure = 0;  ///< pressure of the stroke that the hand draws, 0 to 1; 0: no stroke
    bool fused = false;   ///< surfaces have joined
    bool refused = false; ///< the hand has asked for something that is impossible now
    bool stepped = false; ///< the hand has chosen something: a tool, a channel, a switch, a button of a panel
    double hold = 0;      ///< progress of the button that the hand holds, 0 to 1
};

/// Converts events to haptic pulses. Each frame has at most one pulse for each hand: that of its most important event.
/// The texture of a surface is felt after that pulse has ended. A series of fusions, or of refusals, is felt once, at
/// its beginning.
///
/// Uses no clock except the frames' times. The texture is a train of pulses that fills the same share of the time at 5
/// frames a second as at 144.
class Haptics
{
public:
    explicit Haptics(const HapticLevels& levels = {}) : m_levels(levels) {}

    void setLevels(const HapticLevels& levels) { m_levels = levels; }

    /// Returns the pulses of a frame. Units: `time` in seconds. `hands` is indexed by Side.
    std::vector<HapticPulse> step(double time, const std::array<HapticInput, sideCount>& hands);

private:
    struct Hand
    {
        bool touched = false;
        double contactFrom = 0; ///< time before which a contact gives no pulse, seconds
        /// Times before which a fusion or a refusal continues the last series, which was felt already, seconds.
        double fusionFrom = 0, refusalFrom = 0;
        double hold = 0;
        double quietUntil = 0;         ///< the texture gives no pulse until then, seconds
        std::optional<double> trainAt; ///< time of the last texture pulse, seconds; none: no texture is felt
    };

    struct Event
    {
        Sensation what;
        double strength; ///< fraction of the sensation's full strength, 0 to 1
    };

    Hand& at(Side side) { return m_hands[static_cast<std::size_t>(side)]; }
    double levelOf(Sensation what) const { return m_levels.of[static_cast<std::size_t>(what)]; }
    static std::optional<Event> eventOf(Hand& hand, const HapticInput& input, double time);
    std::optional<HapticPulse> event(Side side, const HapticInput& input, double time);
    std::optional<HapticPulse> texture(Side side, const HapticInput& input, double time);

    HapticLevels m_levels;
    std::array<Hand, sideCount> m_hands;
};
} // namespace vr
