#include "vr/panels/panel_pointer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vr
{
namespace
{
constexpr double ringSteps = 24; ///< steps in which a ring fills: each step needs a new picture of the panel

bool isThere(PanelKind kind, std::span<const PlacedPanel> panels)
{
    return std::ranges::any_of(panels, [&](const PlacedPanel& panel) { return panel.layout->kind == kind; });
}
} // namespace

PanelPointer::PressKind PanelPointer::kindOf(const PanelItem& item)
{
    return item.isSlider() ? PressKind::Slide : item.mustHold ? PressKind::Hold : PressKind::Click;
}

void PanelPointer::find(const core::Ray& ray, std::span<const PlacedPanel> panels)
{
    for (const PlacedPanel& panel : panels) {
        const std::optional<PlanePoint> point = intersect(ray, panel.pose);
        const bool counts =
            point && (m_press ? panel.layout->kind == m_press->panel : panel.layout->contains(point->at));
        if (counts && (!m_place || point->distance < m_place->point.distance))
            m_place = Place{panel, *point};
    }
    const bool slides = m_press && m_press->kind == PressKind::Slide;
    if (m_place && (slides || m_place->panel.layout->contains(m_place->point.at)))
        m_spot = Spot{m_place->panel.layout->kind, ray.origin + m_place->point.distance * ray.direction.normalized()};
}

std::optional<PanelAction> PanelPointer::aim(const std::optional<Aim>& aim, double time,
                                             std::span<const PlacedPanel> panels)
{
    m_time += m_clock.step(time);
    m_place.reset();
    m_spot.reset();
    if (m_press && !isThere(m_press->panel, panels))
        m_press.reset();
    if (aim)
        find(aim->ray, panels);
    const std::optional<PanelAction> poked = poke(aim);
    return poked ? poked : keepPressing();
}

void PanelPointer::lookAway()
{
    m_before.reset();
    if (m_press)
        return;
    m_place.reset();
    m_spot.reset();
}

/// Handles a press by the tip. It begins when the tip goes through an item from the front, and ends when the tip comes
/// back or leaves sideways.
std::optional<PanelAction> PanelPointer::poke(const std::optional<Aim>& aim)
{
    const bool isThrough = aim && m_spot && m_place->point.distance < aim->tip;
    const std::optional<PanelKind> before =
        std::exchange(m_before, m_spot && !isThrough ? std::optional(m_spot->kind) : std::nullopt);
    if (m_press && m_press->isPoke && !isThrough)
        return release(m_spot.has_value());
    const bool begins = !m_press && isThrough && aim->mayPoke && before == m_spot->kind;
    return begins ? begin(true) : std::nullopt;
}

const PanelItem* PanelPointer::itemUnder() const
{
    return m_place ? m_place->panel.layout->itemAt(m_place->point.at) : nullptr;
}

bool PanelPointer::isOnPressed() const
{
    const PanelItem* item = itemUnder();
    return item && isSameItem(*item->action, m_press->item);
}

double PanelPointer::held() const
{
    return std::clamp((m_time - m_press->time) / holdSeconds, 0.0, 1.0);
}

std::optional<PanelAction> PanelPointer::slide()
{
    const PanelItem* item = m_place ? m_place->panel.layout->itemFor(m_press->item) : nullptr;
    if (!item || !item->isSlider())
        return std::nullopt;
    const PanelAction wanted = actionAt(*item, m_place->panel.layout->toPanel(m_place->point.at));
    if (wanted == m_press->item)
        return std::nullopt;
    m_press->item = wanted;
    return wanted;
}

std::optional<PanelAction> PanelPointer::keepPressing()
{
    if (!m_press || m_press->isOver || m_press->kind == PressKind::Click)
        return std::nullopt;
    if (m_press->kind == PressKind::Slide)
        return slide();
    const bool isOn = isOnPressed(), isLongEnough = held() >= 1;
    m_press->isOver = !isOn || isLongEnough;
    return isOn && isLongEnough ? std::optional(m_press->item) : std::nullopt;
}

std::optional<PanelAction> PanelPointer::press()
{
    return begin(false);
}

std::optional<PanelAction> PanelPointer::begin(bool isPoke)
{
    const PanelItem* item = itemUnder();
    if (!item)
        return std::nullopt;
    m_press = Press{kindOf(*item), m_place->panel.layout->kind, *item->action, m_time, isPoke};
    return m_press->kind == PressKind::Slide ? slide() : std::nullopt;
}

std::optional<PanelAction> PanelPointer::release(bool isClick)
{
    const bool acts = m_press && isClick && m_press->kind == PressKind::Click && isOnPressed();
    const std::optional<PanelAction> wanted = acts ? std::optional(m_press->item) : std::nullopt;
    m_press.reset();
    return wanted;
}

std::optional<PanelTouch> PanelPointer::pressedTouch() const
{
    if (m_press->kind == PressKind::Slide)
        return PanelTouch{m_press->item, true};
    if (!isOnPressed() || m_press->isOver)
        return std::nullopt;
    const double share = m_press->kind == PressKind::Hold ? std::round(held() * ringSteps) / ringSteps : 0;
    return PanelTouch{m_press->item, true, share};
}

std::optional<PanelTouch> PanelPointer::touch(PanelKind kind) const
{
    if (m_press)
        return m_press->panel == kind ? pressedTouch() : std::nullopt;
    const PanelItem* item = itemUnder();
    return item && m_place->panel.layout->kind == kind ? std::optional(PanelTouch{*item->action}) : std::nullopt;
}
} // namespace vr
