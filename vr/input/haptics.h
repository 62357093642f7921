#pragma once

#include "vr/openxr/haptic_pulse.h"

#include <optional>
#include <vector>

namespace vr
{
/// What a hand can feel.
enum class Sensation { Contact, Texture, Fusion, Refusal, MenuStep, Hold };
inline constexpr std::size_t sensationCount = 6;

/// How strongly each is felt, 0 to 1; 0: not at all.
struct HapticLevels
{
    std::array<double, sensationCount> of{1, 1, 1, 1, 1, 1}; ///< by Sensation

    bool operator==(const HapticLevels&) const = default;
};

/// What happened to one hand in a frame.
struct HapticInput
{
    bool touches = false; ///< its brush meets the surface
    double pressure = 0;  ///< of the stroke that it draws, 0 to 1; 0: it draws none
    bool fused = false;   ///< surfaces joined
    bool refused = false; ///< what it asked for cannot be
    bool stepped = false; ///< something was chosen: a tool, a channel, a switch, a button of a panel
    double hold = 0;      ///< 0 to 1, of the button that it holds
};

/// Makes pulses of what happens. A frame has one for each hand at most, of what matters most to it, and the texture
/// waits until that has been felt. Surfaces that join dab by dab, and clay that will not give way, are felt once, when
/// that begins. Times are the frames' own: the texture is a train of pulses that takes as large a part of the time at 5
/// frames a second as at 144.
class Haptics
{
public:
    explicit Haptics(const HapticLevels& levels = {}) : m_levels(levels) {}

    void setLevels(const HapticLevels& levels) { m_levels = levels; }

    /// `time` in seconds; `hands` by Side.
    std::vector<HapticPulse> step(double time, const std::array<HapticInput, sideCount>& hands);

private:
    struct Hand
    {
        bool touched = false;
        double contactFrom = 0;                 ///< a contact before that is none
        double fusionFrom = 0, refusalFrom = 0; ///< what happens before that goes on, and was felt
        double hold = 0;
        double quietUntil = 0;         ///< what is felt until then is no texture
        std::optional<double> trainAt; ///< the last pulse of the texture, while that goes on
    };

    struct Event
    {
        Sensation what;
        double strength; ///< 0 to 1
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
