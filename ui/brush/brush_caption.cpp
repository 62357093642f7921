#include "ui/brush/brush_caption.h"

#include "ui/widgets/spacing.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/themed_icon.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace ui
{
namespace
{
/// text size as a multiple of the window's; letters then span 16 minutes of arc at 3 m
constexpr double captionSize = 5.5;
constexpr double minCaption = 1.6; ///< smallest text size as a multiple of the window's
constexpr double shrinksBy = 0.97;
constexpr double maxOfWindow = 0.08; ///< largest caption height as a fraction of the window's height
constexpr double captionGap = 0.55;  ///< space between parts, in cap heights

QFont sizedFont(const QFont& usual, double factor)
{
    QFont font = scaled(usual, factor);
    font.setWeight(QFont::DemiBold);
    return font;
}

/// The rectangles of the caption's parts, from left to right.
struct CaptionLine
{
    CaptionLine(const CaptionText& words, const QFont& font)
    {
        const QFontMetrics metrics(font);
        const int height = metrics.height(), space = static_cast<int>(captionGap * metrics.capHeight());
        int x = gap;
        const auto place = [&](int wide) {
            const QRect part(x, 0, wide, height);
            x += wide + space;
            return part;
        };
        icon = place(height);
        tool = place(metrics.horizontalAdvance(words.tool));
        x += space;
        radius = place(metrics.horizontalAdvance(words.radius));
        if (!words.time.isEmpty()) {
            x += space;
            clock = place(height);
            time = place(metrics.horizontalAdvance(words.time));
        }
        width = x - space + gap;
    }
    QRect icon, tool, radius, clock, time;
    int width = 0;
};
} // namespace

BrushCaption::BrushCaption(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("brushCaption"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    fit();
}

void BrushCaption::setText(const CaptionText& words)
{
    if (m_text == words)
        return;
    m_text = words;
    setAccessibleName(QStringList({words.tool, words.radius, words.time}).join(QStringLiteral(", ")));
    fit();
}

QSize BrushCaption::sizeHint() const
{
    return {CaptionLine(m_text, sizedFont(font(), minCaption)).width, QFontMetrics(m_font).height()};
}

void BrushCaption::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

void BrushCaption::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    window()->installEventFilter(this);
    fit();
}

bool BrushCaption::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == window() && !isWindow())
        fit();
    return QWidget::eventFilter(watched, event);
}

void BrushCaption::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange)
        fit();
    update();
}

void BrushCaption::fit()
{
    const double maxHeight = isWindow() ? QWIDGETSIZE_MAX : maxOfWindow * window()->height();
    const auto fits = [&](double factor) {
        const QFont font = sizedFont(this->font(), factor);
        return CaptionLine(m_text, font).width <= width() && QFontMetrics(font).height() <= maxHeight;
    };
    double factor = captionSize;
    while (factor > minCaption && !fits(factor))
        factor *= shrinksBy;
    m_font = sizedFont(font(), std::max(factor, minCaption));
    if (const int height = QFontMetrics(m_font).height(); minimumHeight() != height)
        setFixedHeight(height);
    update();
}

/// The end of a turn is shown by a clock icon and by light letters on dark ground, not by colour alone.
void BrushCaption::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const CaptionLine line(m_text, m_font);
    const int inset = QFontMetrics(m_font).descent() / 2;
    const auto drawing = [inset](const QRect& place) { return place.adjusted(inset, inset, -inset, -inset); };
    painter.setFont(m_font);
    painter.setPen(palette().color(QPalette::WindowText));
    m_text.icon.paint(&painter, drawing(line.icon));
    painter.drawText(line.tool, Qt::AlignCenter | Qt::TextSingleLine, m_text.tool);
    painter.drawText(line.radius, Qt::AlignCenter | Qt::TextSingleLine, m_text.radius);
    if (m_text.time.isEmpty())
        return;
    if (m_text.isNearEnd) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::WindowText));
        painter.drawRoundedRect(line.time.adjusted(-gap, inset, gap, -inset), gap, gap);
        painter.setPen(palette().color(QPalette::Window));
    }
    themedIcon(QStringLiteral("clock")).paint(&painter, drawing(line.clock));
    painter.drawText(line.time, Qt::AlignCenter | Qt::TextSingleLine, m_text.time);
}
} // namespace ui
