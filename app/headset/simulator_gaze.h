#pragma once

#include "vr/panels/panel_placement.h"

#include <bitset>
#include <span>

namespace app
{
/// The gaze of the simulated user. Turns the head towards a panel that the user opens until the panel is completely
/// visible, and back when it is closed. Computes only the angles: the caller turns the head.
class SimulatorGaze
{
public:
    /// Returns the angle by which to turn the head now, radians to the left. Called regularly with the visible panels
    /// and the head's pose. `sideTangent`: tangent of half the horizontal field of view. `seconds`: time since the last
    /// call; 0: turn at once.
    double step(std::span<const vr::PanelTarget> panels, const vr::Pose& head, double sideTangent, double seconds);
    /// Called when the user has turned the head: cancels turning, including turning back.
    void cancel();

private:
    static double missing(const vr::PanelTarget& panel, const vr::Pose& head, double sideTangent);

    /// Sets of panels, indexed by vr::PanelKind.
    using Kinds = std::bitset<vr::panelKindCount>;

    Kinds m_open;                         ///< panels that the user has opened
    std::optional<vr::PanelKind> m_panel; ///< the panel being looked at
    bool m_isDone = true;                 ///< true: the panel is completely visible, or the user looks elsewhere
    double m_turned = 0;                  ///< sum of the turns made, to be turned back later, radians to the left
};
} // namespace app
