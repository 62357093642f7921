#include "ui/window/status_bar.h"

#include <QPainter>
#include <QStyleOption>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int margin = 6; ///< pixels beside the message
} // namespace

void StatusBar::paintEvent(QPaintEvent*)
{
    QStyleOption option;
    option.initFrom(this);
    QPainter painter(this);
    style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
    QRect space = rect().adjusted(margin, 0, -margin, 0);
    for (const QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (child->isVisible())
            space.setRight(std::min(space.right(), child->x() - 2 * margin));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(space, Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                     fontMetrics().elidedText(currentMessage(), Qt::ElideRight, space.width()));
}
} // namespace ui
