#pragma once

#include "vr/openxr/haptic_pulse.h"
#include "vr/openxr/wand_state.h"
#include "vr/openxr/xr_bindings.h"
#include "vr/openxr/xr_instance.h"

#include <QCoreApplication>
#include <QStringList>

namespace vr
{
// Thresholds of a squeeze, as fractions of the full travel or force. They are high because hands rest on the grips of
// some wands.
inline constexpr float squeezePress = 0.7F, squeezeRelease = 0.5F;

/// Reads the poses and buttons of the wands, and sends haptic pulses to them. Precondition: made once for each session,
/// before the session begins. All members except refusedProfiles() throw XrError.
class Actions
{
    Q_DECLARE_TR_FUNCTIONS(vr::Actions)

public:
    Actions(const Instance& instance, XrSession session);

    /// Returns the wands at `time` in the space `room`. Without the focus the buttons count as released, and the
    /// runtime is not asked for them. A pose that is not known keeps its last value.
    Wands read(XrSpace room, XrTime time, bool hasFocus);

    /// Starts a vibration. Precondition: the session has the focus; otherwise nothing is felt.
    void pulse(const HapticPulse& pulse);

    /// Reads the kind of each wand again. To be called when the runtime reports a new kind, and when the session gains
    /// the focus.
    void refreshProfiles();

    /// Returns the kinds of wands that the runtime refuses, each with the name of its result.
    const QStringList& refusedProfiles() const { return m_refused; }

private:
    struct Hand
    {
        XrPath path = XR_NULL_PATH;
        SpaceHandle grip, aim, pinch;
        bool isStick = false, isSimple = false, isHand = false; ///< see WandState
        bool isSqueezed = false;                                ///< the side control was squeezed in the last frame
    };

    static QString nameOf(Control control);
    void makeActions();
    void suggest(const WandProfile& profile);
    void attach();
    SpaceHandle makeSpace(Control control, XrPath hand) const;
    bool sync();
    void readPoses(std::size_t side, XrSpace room, XrTime time);
    void readButtons(std::size_t side);
    XrActionStateGetInfo stateGetInfo(Control control, std::size_t side) const;
    bool isPressed(Control control, std::size_t side) const;
    double amountOf(Control control, std::size_t side) const;
    XrAction action(Control control) const { return m_actions[static_cast<std::size_t>(control)].get(); }

    const Instance& m_instance;
    XrSession m_session;
    ActionSetHandle m_set;
    std::array<ActionHandle, controlCount> m_actions; ///< indexed by Control
    std::array<Hand, sideCount> m_hands;              ///< indexed by Side
    Wands m_wands;
    QStringList m_refused;
};
} // namespace vr
