#pragma once

#include "vr/gl/texture.h"
#include "vr/panels/panel_images.h"
#include "vr/panels/panel_pointer.h"
#include "vr/scene/scene_state.h"

namespace vr
{
/// The panels of a visit: which are open, where they are, what they show, and what the two wands do at them. Panels are
/// painted on another thread (PanelImages) and appear when they are ready. Thread: the headset's.
class PanelManager
{
public:
    /// Precondition: the context of create() is current at place() and destroy().
    void create(QOpenGLExtraFunctions* gl);
    void destroy();

    /// Opens or closes a panel. A panel that opens is placed where the user looks, unless it is attached to a hand. Of
    /// Tools, Files, Settings and Parts only one is open at a time: a new one appears in the direction of the one that
    /// it replaces.
    void open(PanelKind kind, bool isOpen = true);
    bool isOpen(PanelKind kind) const { return at(kind).isOpen; }
    /// Discards the places of all panels, because room space has changed. The next place() chooses new ones.
    void resetPlacement();

    /// Sets the content of an open panel. To be called each frame. `opacity`: 0 to 1; at 0 the panel is absent.
    void show(const PanelContent& content, float opacity = 1);

    /// Input of place(), which is called once a frame before aim(). Units: room space.
    struct Sight
    {
        Pose head;
        std::array<std::optional<Pose>, sideCount> grips; ///< indexed by Side; none: the hand is not tracked
        Side sculpting = Side::Right;                     ///< hand with the colour panel; the other hand has the tools
        /// Ball that panels stay out of; it must not hide them either.
        core::Sphere model;
        bool isOneHanded = false; ///< no panel is attached to a hand
    };
    void place(const Sight& sight);
    /// Returns the pose at which a panel opens that is attached to no hand. `replaced`: pose of the panel that it
    /// replaces.
    static Pose placeOnOpening(PanelKind kind, const Sight& sight, const PanelLayout& layout,
                               const std::optional<Pose>& replaced = {});

    /// Returns the action of a slider that moved, of an item held long enough or of a poke; none if there is none. To
    /// be called once per frame and hand, before press() and release(). `aim`: none if the wand is lost. A hand cannot
    /// point at a panel that it carries.
    std::optional<PanelAction> aim(Side side, const std::optional<PanelPointer::Aim>& aim, double time);
    /// Ignores what the hand points at, because the hand is doing something else.
    void lookAway(Side side) { pointer(side).lookAway(); }
    /// Returns the point of a panel at which a hand points; none if it points at no panel.
    const std::optional<PanelPointer::Spot>& spot(Side side) const { return pointer(side).spot(); }
    std::optional<PanelAction> press(Side side) { return pointer(side).press(); }
    std::optional<PanelAction> release(Side side, bool isClick) { return pointer(side).release(isClick); }

    /// Returns the panels at which wands may point.
    std::vector<PanelTarget> targets() const;

    /// Replaces the contents of `panels` by the visible panels.
    void list(std::vector<Panel>& panels) const;

private:
    struct Place
    {
        bool isOpen = false;
        std::optional<Pose> pose;
        std::optional<Pose> replaced; ///< pose of the panel that this one replaces
        PlacedPanel placed;           ///< its layout is null until the panel was painted
        Texture picture;
        float opacity = 1;
    };

    Place& at(PanelKind kind) { return m_places[static_cast<std::size_t>(kind)]; }
    const Place& at(PanelKind kind) const { return m_places[static_cast<std::size_t>(kind)]; }
    PanelPointer& pointer(Side side) { return m_pointers[static_cast<std::size_t>(side)]; }
    const PanelPointer& pointer(Side side) const { return m_pointers[static_cast<std::size_t>(side)]; }
    static bool isThere(const Place& place);
    std::optional<Side> carrier(PanelKind kind) const;
    Pose placeOf(PanelKind kind, const Sight& sight) const;
    Pose placeOfNotice(const Sight& sight) const;
    void takePicture();

    PanelImages m_images;
    std::array<Place, panelKindCount> m_places;     ///< indexed by PanelKind
    std::array<PanelPointer, sideCount> m_pointers; ///< indexed by Side
    std::vector<PlacedPanel> m_targets;             ///< panels at which the wand of the last aim() may point
    Side m_sculpting = Side::Right;
    bool m_isOneHanded = false;
    std::size_t m_turn = 0; ///< kind of panel whose picture is looked for first
};
} // namespace vr
