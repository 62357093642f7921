#include "vr/panels/panel_layout.h"

#include "vr/panels/panel_theme.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vr
{
Eigen::Vector2d PanelLayout::metres() const
{
    return Eigen::Vector2d(size.width(), size.height()) * distance / 1000;
}

QPointF PanelLayout::toPanel(const Eigen::Vector2d& point) const
{
    const Eigen::Vector2d dmm = point * 1000 / distance;
    return {size.width() / 2 + dmm.x(), size.height() / 2 - dmm.y()};
}

bool PanelLayout::contains(const Eigen::Vector2d& point) const
{
    return QRectF(QPointF(), size).contains(toPanel(point));
}

const PanelItem* PanelLayout::itemAt(const Eigen::Vector2d& point) const
{
    const QPointF at = toPanel(point);
    const auto item =
        std::ranges::find_if(items, [&](const PanelItem& p) { return p.isInteractive() && p.area.contains(at); });
    return item == items.end() ? nullptr : &*item;
}

const PanelItem* PanelLayout::itemFor(const PanelAction& action) const
{
    const auto item = std::ranges::find_if(
        items, [&](const PanelItem& p) { return p.isInteractive() && isSameItem(*p.action, action); });
    return item == items.end() ? nullptr : &*item;
}

std::optional<PanelAction> PanelLayout::hit(const Eigen::Vector2d& point) const
{
    const PanelItem* item = itemAt(point);
    return item ? std::optional(actionAt(*item, toPanel(point))) : std::nullopt;
}

QLineF sliderTrack(const QRectF& area)
{
    const double inset = std::min(theme::knobWidth / 2 + theme::itemCorner, area.width() / 2);
    return {area.left() + inset, area.center().y(), area.right() - inset, area.center().y()};
}

double sliderShare(const SliderLook& look, double value)
{
    return std::clamp((value - look.min) / (look.max - look.min), 0.0, 1.0);
}

PanelAction actionAt(const PanelItem& item, const QPointF& point)
{
    assert(item.isInteractive());
    const auto* look = std::get_if<SliderLook>(&item.look);
    if (!look)
        return *item.action;
    const QLineF track = sliderTrack(item.area);
    const double share = std::clamp((point.x() - track.x1()) / track.dx(), 0.0, 1.0);
    const double steps = std::round(share * (look->max - look->min) / look->step);
    const double value = std::min(look->min + steps * look->step, look->max);
    return Slide{std::get<Slide>(*item.action).slider, value};
}
} // namespace vr
