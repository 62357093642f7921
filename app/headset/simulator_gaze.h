#pragma once

#include "vr/panels/panel_placement.h"

#include <bitset>
#include <span>

namespace app
{
/// The eyes of the simulated user, who has no neck to look with: the head turns to a panel that the user opens, until
/// that is seen whole, and back when it has gone. Pure.
class SimulatorGaze
{
public:
    /// Takes, once in a while, the panels that are there, where the head is, and how far it sees to a side, as a
    /// tangent. Returns how far the head turns now, radians to the left. `seconds`: since the last time; 0: at once.
    double step(std::span<const vr::PanelTarget> panels, const vr::Pose& head, double sideTangent, double seconds);
    /// The user has turned the head: it stays.
    void letGo();

private:
    static double missing(const vr::PanelTarget& panel, const vr::Pose& head, double sideTangent);

    /// Places by kind of panel.
    using Kinds = std::bitset<vr::panelKindCount>;

    Kinds m_open;                         ///< that the user has opened
    std::optional<vr::PanelKind> m_panel; ///< at which it looks
    bool m_isDone = true;                 ///< it is seen whole, or the user looks elsewhere
    double m_turned = 0;                  ///< radians to the left that are to be turned back
};
} // namespace app
