#pragma once

#include "vr/gl/texture.h"
#include "vr/panels/panel_images.h"
#include "vr/panels/panel_pointer.h"
#include "vr/scene/scene_state.h"

namespace vr
{
/// The panels of a visit: which are open, where they stand, what is seen of them, and what two wands do at them. The
/// headset's thread; panels are painted on another (PanelImages), and appear when they are.
class PanelManager
{
public:
    /// The context that was current at create() must be current at show(), list() and destroy().
    void create(QOpenGLExtraFunctions* gl);
    void destroy();

    /// A panel that opens is placed anew where the person looks, unless it goes with a hand. Of the tools and what they
    /// lead to, files and settings, one is open at a time: the next one takes its place, where the person looks.
    void open(PanelKind kind, bool isOpen = true);
    bool isOpen(PanelKind kind) const { return at(kind).isOpen; }
    /// Room space has changed: all are placed again.
    void resetPlacement();

    /// For each open panel, each frame. `opacity`: 0 to 1; one of 0 is not there.
    void show(const PanelContent& content, float opacity = 1);

    /// Once a frame, before wands point. Room space.
    struct Sight
    {
        Pose head;
        std::array<std::optional<Pose>, sideCount> grips; ///< by Side; none: the hand is not seen
        Side sculpting = Side::Right;                     ///< has the colours, the other the tools
        core::Sphere model;                               ///< which panels keep out of
        bool isOneHanded = false;                         ///< no panel goes with a hand
    };
    void place(const Sight& sight);
    /// Returns where a panel that goes with no hand is placed when it opens, perhaps in another's place. Pure.
    static Pose placeOnOpening(PanelKind kind, const Sight& sight, const PanelLayout& layout,
                               const std::optional<Pose>& replaced = {});

    /// Returns what a slider, a held item or a poke asks for. Call once per frame and hand, before press() and
    /// release(). No aim: the wand is lost. A hand cannot point at a panel that it carries.
    std::optional<PanelAction> aim(Side side, const std::optional<PanelPointer::Aim>& aim, double time);
    /// The hand is about something else than what it points at.
    void lookAway(Side side) { pointer(side).lookAway(); }
    /// Where that hand points.
    const std::optional<PanelPointer::Spot>& spot(Side side) const { return pointer(side).spot(); }
    std::optional<PanelAction> press(Side side) { return pointer(side).press(); }
    std::optional<PanelAction> release(Side side, bool isClick) { return pointer(side).release(isClick); }

    /// Panels at which wands may point.
    std::vector<PanelTarget> targets() const;

    /// What is seen: into `panels`, in place of what that held.
    void list(std::vector<Panel>& panels) const;

private:
    struct Place
    {
        bool isOpen = false;
        std::optional<Pose> pose;
        std::optional<Pose> replaced; ///< of the panel whose place it takes
        PlacedPanel placed;           ///< its layout is null until it was painted
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
    std::array<Place, panelKindCount> m_places;     ///< by PanelKind
    std::array<PanelPointer, sideCount> m_pointers; ///< by Side
    std::vector<PlacedPanel> m_targets;             ///< of aim()
    Side m_sculpting = Side::Right;
    bool m_isOneHanded = false;
    std::size_t m_turn = 0; ///< whose picture is looked for first
};
} // namespace vr
