#pragma once

#include <QProxyStyle>

namespace ui
{
bool isDark(const QPalette& palette);
/// The colour of a line that parts things: a fifth of the way from the window's colour to the text's.
QColor hairline(const QPalette& palette);

/// Qt's Fusion style, but for what it draws badly in the dark: outlines of boxes to tick, lines that part things,
/// shadows of what is disabled, and what is chosen among tabs and tool buttons, which has the highlight's colour here;
/// and but for the buttons in the titles of panels, the arrow of a tool bar that has more, the signs beside questions
/// and sentences, the pictures on a dialog's buttons, which are left out, and the room about their words.
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
