#include "ui/widgets/theme.h"

#include "ui/widgets/app_style.h"

#include <QApplication>

#include <cmath>

namespace ui
{
namespace
{
struct Colors
{
    QColor window, base, alternate, button, text, faint, highlight, link, tip;
};

QPalette paletteOf(const Colors& c)
{
    QPalette palette(c.button, c.window);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        palette.setColor(role, c.text);
    palette.setColor(QPalette::Base, c.base);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::ToolTipBase, c.tip);
    palette.setColor(QPalette::PlaceholderText, c.faint);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Highlight, c.highlight);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, c.link);
    palette.setColor(QPalette::LinkVisited, c.link);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, c.faint);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.faint);
    return palette;
}

} // namespace

QPalette lightPalette()
{
    return paletteOf({.window = {238, 240, 242},
                      .base = {255, 255, 255},
                      .alternate = {245, 247, 249},
                      .button = {240, 242, 244},
                      .text = {28, 31, 36},
                      .faint = {102, 108, 116},
                      .highlight = {38, 116, 184},
                      .link = {24, 96, 164},
                      .tip = {255, 255, 255}});
}

QPalette darkPalette()
{
    return paletteOf({.window = {45, 48, 53},
                      .base = {31, 33, 37},
                      .alternate = {38, 40, 45},
                      .button = {56, 60, 66},
                      .text = {226, 229, 233},
                      .faint = {150, 155, 163},
                      .highlight = {46, 118, 184},
                      .link = {116, 178, 236},
                      .tip = {62, 66, 72}});
}

QFont scaled(QFont font, double factor)
{
    if (font.pointSizeF() > 0)
        font.setPointSizeF(factor * font.pointSizeF());
    else
        font.setPixelSize(static_cast<int>(std::lround(factor * font.pixelSize())));
    return font;
}

Theme::Theme(ThemeChoice choice, QObject* parent)
    : QObject(parent)
    , m_choice(choice)
    , m_startedDark(ui::isDark(QApplication::palette()))
{
    connect(&m_system, &SystemColorScheme::changed, this, &Theme::apply);
    QApplication::setStyle(new AppStyle);
    apply();
}

void Theme::choose(ThemeChoice choice)
{
    m_choice = choice;
    apply();
}

bool Theme::isDark() const
{
    if (m_choice != ThemeChoice::System)
        return m_choice == ThemeChoice::Dark;
    return m_system.scheme() == SystemColorScheme::Scheme::Unknown
               ? m_startedDark
               : m_system.scheme() == SystemColorScheme::Scheme::Dark;
}

void Theme::apply()
{
    QApplication::setPalette(isDark() ? darkPalette() : lightPalette());
}
} // namespace ui
