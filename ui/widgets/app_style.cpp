#include "ui/widgets/app_style.h"

#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QPainter>
#include <QStyleOption>
#include <QTabBar>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int tabBar = 2; ///< thickness of the bar along the selected tab, pixels

QRect middleOf(const QRect& rect, Qt::Orientation along)
{
    const QPoint middle = rect.center();
    return along == Qt::Horizontal ? QRect(rect.left(), middle.y(), rect.width(), 1)
                                   : QRect(middle.x(), rect.top(), 1, rect.height());
}

/// Draws a tab; the selected one has a bar at the edge towards its page.
void drawTab(const QStyleOptionTab& tab, QPainter* painter)
{
    const bool isChosen = tab.state & QStyle::State_Selected,
               isHot = tab.state & QStyle::State_MouseOver && tab.state & QStyle::State_Enabled;
    if (isHot && !isChosen) {
        QColor shade = tab.palette.color(QPalette::WindowText);
        shade.setAlphaF(0.08F);
        painter->fillRect(tab.rect, shade);
    }
    if (!isChosen)
        return;
    QRect bar = tab.rect;
    if (tab.shape == QTabBar::RoundedSouth || tab.shape == QTabBar::TriangularSouth)
        bar.setBottom(bar.top() + tabBar - 1);
    else
        bar.setTop(bar.bottom() - tabBar + 1);
    painter->fillRect(bar, tab.palette.highlight());
}

/// Draws a checked tool button: a frame in the highlight colour, filled with a translucent shade of it.
void drawPressed(const QStyleOption& option, QPainter* painter)
{
    const QColor frame = option.palette.color(QPalette::Highlight);
    QColor shade = frame;
    shade.setAlphaF(option.state & QStyle::State_MouseOver ? 0.35F : 0.25F);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(frame);
    painter->setBrush(shade);
    painter->drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
    painter->restore();
}
} // namespace

QColor hairline(const QPalette& palette)
{
    QColor line = palette.color(QPalette::WindowText);
    line.setAlphaF(0.2F);
    return line;
}

bool isDark(const QPalette& palette)
{
    return palette.window().color().lightness() < palette.windowText().color().lightness();
}

int AppStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const
{
    return hint == SH_DialogButtonBox_ButtonsHaveIcons || hint == SH_EtchDisabledText
               ? 0
               : QProxyStyle::styleHint(hint, option, widget, data);
}

int AppStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
    switch (metric) {
    case PM_ToolBarSeparatorExtent:
    case PM_TabBarTabHSpace:
        return 2 * gap;
    case PM_MessageBoxIconSize:
        return 4 * gap;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

/// Widens push buttons, so that their text does not touch the frame.
QSize AppStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                 const QWidget* widget) const
{
    QSize whole = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (type == CT_PushButton)
        whole.setWidth(std::max(whole.width(), size.width() + 3 * gap));
    return whole;
}

/// Indents the titles of panels to align with their contents.
QRect AppStyle::subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const
{
    const QRect rect = QProxyStyle::subElementRect(element, option, widget);
    if (element != SE_DockWidgetTitleBarText)
        return rect;
    return option->direction == Qt::RightToLeft ? rect.adjusted(0, 0, -gap / 2, 0) : rect.adjusted(gap / 2, 0, 0, 0);
}

QIcon AppStyle::standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const
{
    switch (icon) {
    case SP_TitleBarNormalButton:
        return themedIcon(QStringLiteral("panel-float"));
    case SP_TitleBarCloseButton:
        return themedIcon(QStringLiteral("panel-close"));
    case SP_ToolBarHorizontalExtensionButton:
    case SP_ToolBarVerticalExtensionButton:
        return themedIcon(QStringLiteral("next"));
    case SP_MessageBoxInformation:
        return themedIcon(QStringLiteral("about"));
    case SP_MessageBoxQuestion:
        return themedIcon(QStringLiteral("question"));
    case SP_MessageBoxWarning:
    case SP_MessageBoxCritical:
        return themedIcon(QStringLiteral("unsound"));
    default:
        return QProxyStyle::standardIcon(icon, option, widget);
    }
}

void AppStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                           const QWidget* widget) const
{
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
    if (element == CE_ToolBar)
        painter->fillRect(option->rect, option->palette.window());
    else if (element == CE_TabBarTabShape && tab)
        drawTab(*tab, painter);
    else if (element == CE_MenuItem && item && item->menuItemType == QStyleOptionMenuItem::Separator &&
             item->text.isEmpty())
        painter->fillRect(middleOf(option->rect.adjusted(gap / 2, 0, -gap / 2, 0), Qt::Horizontal),
                          hairline(option->palette));
    else
        QProxyStyle::drawControl(element, option, painter, widget);
}

void AppStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const
{
    if (element == PE_IndicatorToolBarSeparator) { // the line is drawn across the tool bar
        const bool isUpright = option->state & State_Horizontal;
        const QRect area =
            isUpright ? option->rect.adjusted(0, gap / 2, 0, -gap / 2) : option->rect.adjusted(gap / 2, 0, -gap / 2, 0);
        painter->fillRect(middleOf(area, isUpright ? Qt::Vertical : Qt::Horizontal), hairline(option->palette));
        return;
    }
    if (element == PE_PanelButtonTool && option->state & State_On) {
        drawPressed(*option, painter);
        return;
    }
    if (element == PE_FrameTabBarBase) {
        painter->fillRect(option->rect, hairline(option->palette));
        return;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isOutlined = option->state & State_HasFocus && option->state & State_KeyboardFocusChange;
    if ((element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton) || !isDark(option->palette) ||
        isOutlined)
        return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, element == PE_IndicatorRadioButton);
    painter->setPen(option->palette.color(QPalette::Disabled, QPalette::WindowText));
    painter->setBrush(Qt::NoBrush);
    if (element == PE_IndicatorCheckBox)
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    else
        painter->drawEllipse(QRectF(option->rect).adjusted(1, 1, -1, -1));
    painter->restore();
}
} // namespace ui
