#include "vr/panels/panel_painter.h"

#include "vr/panels/item_painter.h"
#include "vr/panels/panel_icons.h"
#include "vr/panels/panel_theme.h"

#include <QPainter>

#include <cmath>

namespace vr
{
namespace
{
ItemState stateOf(const PanelItem& item, const PanelTouches& touches)
{
    ItemState state{.isEnabled = item.isEnabled, .mustHold = item.mustHold};
    for (const std::optional<PanelTouch>& touch : touches) {
        if (!touch || !item.isInteractive() || !isSameItem(*item.action, touch->item))
            continue;
        state.isHovered = true;
        state.isPressed = state.isPressed || touch->isPressed;
        state.held = std::max(state.held, touch->held);
    }
    return state;
}

void paintGround(QPainter& painter, const QSizeF& size)
{
    const double half = theme::outline / 2;
    painter.setPen(QPen(theme::rim, theme::outline));
    painter.setBrush(theme::ground);
    painter.drawRoundedRect(QRectF(QPointF(), size).adjusted(half, half, -half, -half), theme::corner, theme::corner);
}
} // namespace

QImage paint(const PanelLayout& layout, const PanelTouches& touches, double pixelsPerDmm)
{
    const QSizeF pixels = layout.size * pixelsPerDmm;
    QImage picture(static_cast<int>(std::lround(pixels.width())), static_cast<int>(std::lround(pixels.height())),
                   QImage::Format_RGBA8888_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
    painter.scale(picture.width() / layout.size.width(), picture.height() / layout.size.height());
    paintGround(painter, layout.size);
    for (const PanelItem& item : layout.items)
        paintItem(painter, item, stateOf(item, touches));
    return picture;
}
} // namespace vr
