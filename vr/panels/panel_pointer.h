#pragma once

#include "vr/panels/panel_painter.h"
#include "vr/panels/panel_placement.h"

#include "vr/input/wand_gestures.h"

#include <memory>
#include <span>

namespace vr
{
/// A panel in the room, as it is seen.
struct PlacedPanel
{
    Pose pose;
    std::shared_ptr<const PanelLayout> layout; ///< never null
};

/// Wand that points at panels and presses their items, by its trigger or by its tip, which is put through an item
/// and drawn back. Pure: no clock but the frames' own.
///
/// A press acts when it is let go over the item on which it began. A slider follows it from the first moment on, also
/// beyond its ends and the panel's edge. An item that must be held acts once, when it has been held for holdSeconds
/// without leaving it; a FrameClock says how long that is. What began on one panel never acts on another, and a panel
/// that goes away takes the press with it.
class PanelPointer
{
public:
    /// The nearest panel that it points at, from the front.
    struct Spot
    {
        PanelKind kind;
        core::Vec3 point; ///< room space
    };

    /// Pose of a wand.
    struct Aim
    {
        core::Ray ray;       ///< from the palm
        double tip = 0;      ///< metres from there along the ray
        bool mayPoke = true; ///< false: the hand does something else
    };

    /// Call once a frame, before press() and release(). Nothing: the wand is lost. `time` in seconds. What a slider, a
    /// held item or a poke wants.
    std::optional<PanelAction> aim(const std::optional<Aim>& aim, double time, std::span<const PlacedPanel> panels);
    /// The hand is about something else than what it points at.
    void lookAway();
    /// As vr::PressPanel and vr::ReleasePanel have it. A press elsewhere than on an item does nothing.
    std::optional<PanelAction> press();
    std::optional<PanelAction> release(bool isClick);

    const std::optional<Spot>& spot() const { return m_spot; }
    /// For its picture; nothing if it does nothing there.
    std::optional<PanelTouch> touch(PanelKind kind) const;

private:
    /// On a panel's plane.
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
        bool isOver = false; ///< what must be held has acted, or was left
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
    double m_time = 0;            ///< seconds, by the clock
    std::optional<Place> m_place; ///< where it points; while it presses, on the plane of the panel that it presses
    std::optional<Spot> m_spot;
    std::optional<Press> m_press;
    std::optional<PanelKind> m_before; ///< the panel that the tip was right before, in the last frame
};
} // namespace vr
