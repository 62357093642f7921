#pragma once

#include <QProxyStyle>

namespace ui
{
bool isDark(const QPalette& palette);
/// Returns the colour of separator lines: the text colour with an opacity of 20 %.
QColor hairline(const QPalette& palette);

/// Qt's Fusion style with corrections, mainly for dark palettes. Draws the outlines of check boxes, separator lines,
/// and selected tabs and tool buttons, which get the highlight colour. Draws no shadows under disabled text. Replaces
/// the icons of panel titles, tool bar extensions and message boxes. Removes the icons of dialog buttons and widens the
/// buttons.
class AppStyle : public QProxyStyle
{
public:
    AppStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                           const QWidget* widget) const override;
    QRect subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
};
} // namespace ui
