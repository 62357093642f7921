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

const PanelPart* PanelLayout::partAt(const Eigen::Vector2d& point) const
{
    const QPointF at = toPanel(point);
    const auto part =
        std::ranges::find_if(parts, [&](const PanelPart& p) { return p.answers() && p.area.contains(at); });
    return part == parts.end() ? nullptr : &*part;
}

const PanelPart* PanelLayout::partFor(const PanelAction& action) const
{
    const auto part =
        std::ranges::find_if(parts, [&](const PanelPart& p) { return p.answers() && isSameItem(*p.action, action); });
    return part == parts.end() ? nullptr : &*part;
}

std::optional<PanelAction> PanelLayout::hit(const Eigen::Vector2d& point) const
{
    const PanelPart* part = partAt(point);
    return part ? std::optional(actionAt(*part, toPanel(point))) : std::nullopt;
}

QLineF sliderTrack(const QRectF& area)
{
    const double inset = std::min(theme::knobWidth / 2 + theme::itemCorner, area.width() / 2);
    return {area.left() + inset, area.center().y(), area.right() - inset, area.center().y()};
}

double sliderShare(const SliderLook& look, double value)
{
    return std::clamp((value - look.least) / (look.most - look.least), 0.0, 1.0);
}

PanelAction actionAt(const PanelPart& part, const QPointF& point)
{
    assert(part.answers());
    const auto* look = std::get_if<SliderLook>(&part.look);
    if (!look)
        return *part.action;
    const QLineF track = sliderTrack(part.area);
    const double share = std::clamp((point.x() - track.x1()) / track.dx(), 0.0, 1.0);
    const double steps = std::round(share * (look->most - look->least) / look->step);
    const double value = std::min(look->least + steps * look->step, look->most);
    return Slide{std::get<Slide>(*part.action).slider, value};
}
} // namespace vr
