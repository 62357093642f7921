#pragma once

#include "vr/panels/panel_painter.h"
#include "vr/panels/panel_placement.h"

#include "vr/input/wand_gestures.h"

#include <memory>
#include <span>

namespace vr
{
/// A panel as it is placed in the room.
struct PlacedPanel
{
    Pose pose;
    std::shared_ptr<const PanelLayout> layout; ///< not null when it is passed to PanelPointer::aim()
};

/// A wand that points at panels and presses their items by its trigger or by its tip. The tip presses an item by a
/// poke: it is put through the item and drawn back. The only clock is the frames' times.
///
/// A press acts when it is released over the item on which it began. A slider follows the wand from the beginning of
/// the press, even beyond the slider's ends and the panel's edge. An item that must be held acts once, when it was held
/// for holdSeconds without a break; a FrameClock measures the time. A press that began on one panel never acts on
/// another, and ends when its panel disappears.
class PanelPointer
{
public:
    /// The point at which the wand points, on the nearest panel that it meets from the front.
    struct Spot
    {
        PanelKind kind;
        core::Vec3 point; ///< room space
    };

    /// The ray of a wand, in room space.
    struct Aim
    {
        core::Ray ray;       ///< from the palm in the direction of aim
        double tip = 0;      ///< distance from the palm to the tip, metres
        bool mayPoke = true; ///< false: the hand is busy, so its tip presses nothing
    };

    /// Returns the action of a slider that moved, of an item held long enough or of a poke; none if there is none. To
    /// be called once a frame, before press() and release(). `aim`: none if the wand is lost. Units: `time` in seconds.
    std::optional<PanelAction> aim(const std::optional<Aim>& aim, double time, std::span<const PlacedPanel> panels);
    /// Ignores what the wand points at, because the hand is doing something else. A press in progress goes on.
    void lookAway();
    /// Begins or ends a press by the trigger (vr::PressPanel, vr::ReleasePanel). A press that is not on an item does
    /// nothing.
    std::optional<PanelAction> press();
    std::optional<PanelAction> release(bool isClick);

    const std::optional<Spot>& spot() const { return m_spot; }
    /// Returns what the wand does at an item of a panel, for the panel's picture; none if it touches no item.
    std::optional<PanelTouch> touch(PanelKind kind) const;

private:
    /// A point on a panel's plane.
    struct Place
    {
        PlacedPanel panel;
        PlanePoint point;
    };

    enum class PressKind { Click, Slide, Hold };

    struct Press
    {
        PressKind kind;
        PanelKind panel;
        PanelAction item;
        double time;
        bool isPoke = false;
        bool isOver = false; ///< a held item has acted already, or was left
    };

    static PressKind kindOf(const PanelItem& item);
    void find(const core::Ray& ray, std::span<const PlacedPanel> panels);
    const PanelItem* itemUnder() const;
    bool isOnPressed() const;
    double held() const;
    std::optional<PanelAction> begin(bool isPoke);
    std::optional<PanelAction> poke(const std::optional<Aim>& aim);
    std::optional<PanelAction> keepPressing();
    std::optional<PanelAction> slide();
    std::optional<PanelTouch> pressedTouch() const;

    FrameClock m_clock;
    double m_time = 0;            ///< sum of frame times by m_clock, seconds
    std::optional<Place> m_place; ///< point of the wand's aim; during a press, on the plane of the pressed panel
    std::optional<Spot> m_spot;
    std::optional<Press> m_press;
    std::optional<PanelKind> m_before; ///< panel that the tip was in front of in the last frame
};
} // namespace vr
