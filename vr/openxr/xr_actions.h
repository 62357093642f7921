#pragma once

#include "vr/openxr/haptic_pulse.h"
#include "vr/openxr/wand_state.h"
#include "vr/openxr/xr_bindings.h"
#include "vr/openxr/xr_instance.h"

#include <QCoreApplication>
#include <QStringList>

namespace vr
{
// Shares of the way, or of the force. Hands rest on the grips of some wands: a squeeze is more than that.
inline constexpr float squeezePress = 0.7F, squeezeRelease = 0.5F;

/// The wands: poses and buttons in, pulses out. One for each session, made before it begins. Members throw XrError.
class Actions
{
    Q_DECLARE_TR_FUNCTIONS(vr::Actions)

public:
    Actions(const Instance& instance, XrSession session);

    /// At that time in that space. Without the focus buttons are at rest, and not asked about; a pose that is not known
    /// stays what it was.
    Wands read(XrSpace room, XrTime time, bool hasFocus);

    /// Only with the focus; else it is not felt.
    void pulse(const HapticPulse& pulse);

    /// To be called when the runtime says that a wand is of another kind, and once when the focus is new.
    void refreshProfiles();

    /// Kinds of wands that the runtime does not take, with its result's name.
    const QStringList& refusedProfiles() const { return m_refused; }

private:
    struct Hand
    {
        XrPath path = XR_NULL_PATH;
        SpaceHandle grip, aim;
        bool isStick = false, isSimple = false; ///< as WandState has them
        bool isSqueezed = false;                ///< in the frame before
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
    bool isSqueezed(std::size_t side) const;
    XrAction action(Control control) const { return m_actions[static_cast<std::size_t>(control)].get(); }

    const Instance& m_instance;
    XrSession m_session;
    ActionSetHandle m_set;
    std::array<ActionHandle, controlCount> m_actions; ///< by Control
    std::array<Hand, sideCount> m_hands;              ///< by Side
    Wands m_wands;
    QStringList m_refused;
};
} // namespace vr
