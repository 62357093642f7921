#include "vr/panels/panel_manager.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace vr
{
namespace
{
constexpr double degree = std::numbers::pi / 180;
/// Heights at which a notice may be placed, metres below the eyes (negative: above), the best first.
constexpr double noticeHeights[] = {-0.1, -0.3, 0.3, -0.5};

/// Position of a panel relative to where the user looks; the model is straight ahead.
struct DefaultPosition
{
    double aside; ///< radians to the left
    double below; ///< metres below the eyes
};

DefaultPosition defaultPositionOf(PanelKind kind)
{
    switch (kind) {
    case PanelKind::Tools: // used only if no panel is attached to a hand: out of the way of Files and Settings
        return {12 * degree, 0.3};
    case PanelKind::Color:
        return {-12 * degree, 0.3};
    case PanelKind::Files:
    case PanelKind::Parts:
    case PanelKind::Lesson:
        return {35 * degree, 0.08};
    case PanelKind::Settings:
        return {-35 * degree, 0.08};
    case PanelKind::Performance:
        return {0, -0.38}; // above the model, because the settings, which switch this panel on, are beside it
    default:
        return {0, noticeHeights[0]}; // a little above where the user looks
    }
}

/// Panels of which only one is open at a time: the tool panel, and the panels that its buttons open.
constexpr PanelKind pages[] = {PanelKind::Tools, PanelKind::Files, PanelKind::Settings, PanelKind::Parts};

/// Returns a level head at the same position that looks towards a point.
Pose lookingAt(const core::Vec3& point, const Pose& head)
{
    const core::Vec3 way = point - head.position;
    return {Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(-way.x(), -way.z()), core::Vec3::UnitY())), head.position};
}
} // namespace

void PanelManager::create(QOpenGLExtraFunctions* gl)
{
    for (Place& place : m_places)
        place.picture.create(gl);
}

void PanelManager::destroy()
{
    for (Place& place : m_places)
        place.picture.destroy();
}

void PanelManager::open(PanelKind kind, bool isOpen)
{
    Place& place = at(kind);
    if (isOpen && !place.isOpen) {
        place.pose.reset();
        place.replaced.reset();
        if (std::ranges::find(pages, kind) != std::end(pages))
            for (const PanelKind page : pages)
                if (std::exchange(at(page).isOpen, false))
                    place.replaced = at(page).pose;
    }
    place.isOpen = isOpen;
}

void PanelManager::resetPlacement()
{
    for (Place& place : m_places) {
        place.pose.reset();
        place.replaced.reset();
    }
}

void PanelManager::show(const PanelContent& content, float opacity)
{
    const PanelKind kind = kindOf(content);
    at(kind).opacity = opacity;
    PanelTouches touches;
    for (std::size_t i = 0; i < sideCount; ++i)
        touches[i] = m_pointers[i].touch(kind);
    m_images.show(content, touches);
}

/// Uploads at most one picture in a frame: a picture has a megabyte or two.
void PanelManager::takePicture()
{
    for (std::size_t i = 0; i < panelKindCount; ++i) {
        const std::size_t index = (m_turn + i) % panelKindCount;
        if (std::optional<PanelImage> picture = m_images.take(static_cast<PanelKind>(index))) {
            m_places[index].picture.upload(picture->image);
            m_places[index].placed.layout = std::move(picture->layout);
            m_turn = index + 1;
            return;
        }
    }
}

std::optional<Side> PanelManager::carrier(PanelKind kind) const
{
    if (m_isOneHanded)
        return std::nullopt;
    const Side support = m_sculpting == Side::Right ? Side::Left : Side::Right;
    return kind == PanelKind::Tools   ? std::optional(support)
           : kind == PanelKind::Color ? std::optional(m_sculpting)
                                      : std::nullopt;
}

Pose PanelManager::placeOnOpening(PanelKind kind, const Sight& sight, const PanelLayout& layout,
                                  const std::optional<Pose>& replaced)
{
    const DefaultPosition position = defaultPositionOf(kind);
    AheadPanelPlacement ahead{layout.metres(), layout.distance, replaced ? 0 : position.aside, position.below,
                              sight.model};
    if (kind == PanelKind::Notice)
        ahead.clear.reset();
    return placeAhead(replaced ? lookingAt(replaced->position, sight.head) : sight.head, ahead);
}

Pose PanelManager::placeOf(PanelKind kind, const Sight& sight) const
{
    const Place& place = at(kind);
    if (const std::optional<Side> side = carrier(kind)) {
        const Eigen::Vector2d size = place.placed.layout->metres();
        const std::optional<Pose>& grip = sight.grips[static_cast<std::size_t>(*side)];
        return grip ? placeAtHand(*grip, sight.head, {size, sight.model, *side == Side::Left ? 1.0 : -1.0})
                    : place.pose.value_or(placeAhead(sight.head, {.size = size, .clear = {}}));
    }
    if (place.pose && !isOutOfReach(*place.pose, sight.head))
        return *place.pose;
    if (kind == PanelKind::Notice)
        return placeOfNotice(sight);
    return placeOnOpening(kind, sight, *place.placed.layout, place.pose ? std::nullopt : place.replaced);
}

/// Returns the place at the first of noticeHeights where the notice hides no other panel; else that at the first
/// height.
Pose PanelManager::placeOfNotice(const Sight& sight) const
{
    const PanelLayout& layout = *at(PanelKind::Notice).placed.layout;
    const std::vector<PanelTarget> others = targets();
    const auto below = [&](double metres) {
        return placeAhead(sight.head, {.size = layout.metres(), .distance = layout.distance, .below = metres});
    };
    for (const double metres : noticeHeights) {
        const PanelTarget notice{below(metres), layout.metres(), {}, PanelKind::Notice};
        if (std::ranges::none_of(others, [&](const auto& it) { return overlapInSight(notice, it, sight.head); }))
            return notice.pose;
    }
    return below(noticeHeights[0]);
}

void PanelManager::place(const Sight& sight)
{
    m_sculpting = sight.sculpting;
    m_isOneHanded = sight.isOneHanded;
    takePicture();
    for (std::size_t i = 0; i < panelKindCount; ++i) {
        Place& place = m_places[i];
        if (!isThere(place))
            continue;
        place.pose = placeOf(static_cast<PanelKind>(i), sight);
        place.placed.pose = *place.pose;
    }
}

bool PanelManager::isThere(const Place& place)
{
    return place.isOpen && place.opacity > 0 && place.placed.layout;
}

std::optional<PanelAction> PanelManager::aim(Side side, const std::optional<PanelPointer::Aim>& aim, double time)
{
    m_targets.clear();
    for (std::size_t i = 0; i < panelKindCount; ++i) {
        const auto kind = static_cast<PanelKind>(i);
        if (isThere(m_places[i]) && kind != PanelKind::Notice && carrier(kind) != side)
            m_targets.push_back(m_places[i].placed);
    }
    return pointer(side).aim(aim, time, m_targets);
}

std::vector<PanelTarget> PanelManager::targets() const
{
    std::vector<PanelTarget> targets;
    for (std::size_t i = 0; i < panelKindCount; ++i)
        if (const auto kind = static_cast<PanelKind>(i); isThere(m_places[i]) && kind != PanelKind::Notice)
            targets.push_back({m_places[i].placed.pose, m_places[i].placed.layout->metres(), carrier(kind), kind});
    return targets;
}

void PanelManager::list(std::vector<Panel>& panels) const
{
    panels.clear();
    for (const Place& place : m_places)
        if (isThere(place))
            panels.push_back({place.placed.pose, place.placed.layout->metres(), place.picture.id(), place.opacity});
}
} // namespace vr
