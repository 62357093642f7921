#include "vr/panels/item_painter.h"

#include "vr/panels/panel_icons.h"
#include "vr/panels/panel_theme.h"
#include "vr/panels/text_fit.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
constexpr double padding = 14;     ///< space within a button around its contents, dmm
constexpr double uprightIcon = 66; ///< size of an icon that has its text below it, dmm
constexpr double ringWidth = 5, ringGap = 9;
constexpr double barHeight = 26, colorBarHeight = 46, knobHeight = 58;
constexpr double switchWidth = 104, switchHeight = 52;
constexpr double nameHeight = 46;    ///< height of a tile's name, dmm
constexpr int fullCircle = 360 * 16; ///< full circle in Qt's unit, sixteenths of a degree

QColor colorOf(TextRole role)
{
    return role == TextRole::Faint ? theme::faint : theme::text;
}

TextStyle styleOfText(const TextLook& look, double room)
{
    if (look.role == TextRole::Title)
        return {.height = theme::titleHeight,
                .minHeight = theme::titleHeight * 0.75,
                .lines = look.lines,
                .maxBlockHeight = room,
                .weight = QFont::DemiBold};
    return {.height = theme::bodyHeight, .minHeight = theme::minHeight, .lines = look.lines, .maxBlockHeight = room};
}

class ItemPainter
{
public:
    ItemPainter(QPainter& painter, const PanelItem& item, const ItemState& state)
        : m_painter(painter)
        , m_area(item.area)
        , m_item(item)
        , m_state(state)
    {}

    void operator()(const TextLook& look) const;
    void operator()(const ButtonLook& look) const;
    void operator()(const SwitchLook& look) const;
    void operator()(const SliderLook& look) const;
    void operator()(const SwatchLook& look) const;
    void operator()(const TileLook& look) const;
    void operator()(const WellLook& look) const;

private:
    TextStyle styleOf(const ButtonLook& look, int lines) const;
    void paintUpright(const ButtonLook& look) const;
    void paintAside(const ButtonLook& look) const;
    void paintGround(bool isChosen, bool isFlat) const;
    void paintOutline(const QColor& color = theme::accent) const;
    void paintLines(const FittedText& text, const QRectF& area, Qt::Alignment alignment, const QColor& color) const;
    void paintIcon(const QString& name, const QRectF& area) const;
    void paintRing(const QRectF& icon) const;
    void paintBar(const SliderLook& look, const QLineF& track, double share) const;
    QRectF box(const QRectF& area, double inset) const { return area.adjusted(inset, inset, -inset, -inset); }

    QPainter& m_painter;
    const QRectF m_area;
    const PanelItem& m_item;
    const ItemState m_state;
};

void ItemPainter::operator()(const TextLook& look) const
{
    paintLines(fitted(look.text, m_area.width(), styleOfText(look, m_area.height())), m_area, look.alignment,
               colorOf(look.role));
}

TextStyle ItemPainter::styleOf(const ButtonLook& look, int lines) const
{
    return {.height = theme::bodyHeight,
            .minHeight = theme::minHeight,
            .lines = lines,
            .maxBlockHeight = m_area.height(),
            .weight = look.isChosen ? QFont::DemiBold : QFont::Medium};
}

void ItemPainter::operator()(const ButtonLook& look) const
{
    paintGround(look.isChosen, look.isFlat);
    if (look.isUpright)
        paintUpright(look);
    else
        paintAside(look);
}

/// Paints the icon and the text below it.
void ItemPainter::paintUpright(const ButtonLook& look) const
{
    const QRectF inside = m_area.adjusted(padding / 3, padding, -padding / 3, -padding);
    const QRectF icon(inside.center().x() - uprightIcon / 2, inside.top(), uprightIcon, uprightIcon);
    paintIcon(look.icon, icon);
    const FittedText text = fitted(look.text, inside.width(), styleOf(look, 1));
    paintLines(text, QRectF(QPointF(inside.left(), icon.bottom()), inside.bottomRight()), Qt::AlignHCenter,
               theme::text);
}

/// Paints the icon with its ring, and the text to its right. Icon and text together are centred.
void ItemPainter::paintAside(const ButtonLook& look) const
{
    const QRectF inside = box(m_area, padding);
    const double icon = look.icon.isEmpty() ? 0 : theme::iconHeight, ring = m_state.mustHold ? ringGap + ringWidth : 0;
    const double beside = icon + 2 * ring + (look.icon.isEmpty() || look.text.isEmpty() ? 0 : padding);
    const FittedText text = fitted(look.text, inside.width() - beside, styleOf(look, 2));
    const double left = inside.center().x() - (beside + text.width) / 2;
    const QRectF iconArea(left + ring, inside.center().y() - icon / 2, icon, icon);
    if (!look.icon.isEmpty())
        paintIcon(look.icon, iconArea);
    if (m_state.mustHold)
        paintRing(iconArea);
    paintLines(text, {left + beside, inside.top(), text.width, inside.height()}, Qt::AlignHCenter, theme::text);
}

void ItemPainter::operator()(const SwitchLook& look) const
{
    if (m_state.isHovered)
        paintGround(false, true);
    const QRectF pill(m_area.left() + padding, m_area.center().y() - switchHeight / 2, switchWidth, switchHeight);
    m_painter.setPen(QPen(look.isOn ? theme::chosen : theme::faint, theme::outline));
    m_painter.setBrush(look.isOn ? theme::chosen : theme::well);
    m_painter.drawRoundedRect(box(pill, theme::outline / 2), switchHeight / 2, switchHeight / 2);
    const double knob = switchHeight - 4 * theme::outline,
                 x = look.isOn ? pill.right() - switchHeight / 2 : pill.left() + switchHeight / 2;
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(look.isOn ? theme::text : theme::faint);
    m_painter.drawEllipse(QPointF(x, pill.center().y()), knob / 2, knob / 2);
    const QRectF rest(pill.right() + 2 * padding, m_area.top(), m_area.right() - pill.right() - 3 * padding,
                      m_area.height());
    paintLines(fitted(look.text, rest.width(), styleOfText({}, rest.height())), rest, Qt::AlignLeft, theme::text);
}

void ItemPainter::operator()(const SliderLook& look) const
{
    const QLineF track = sliderTrack(m_area);
    const double share = sliderShare(look, std::get<Slide>(*m_item.action).value);
    paintBar(look, track, share);
    const QPointF middle = track.pointAt(share);
    const double width = m_state.isPressed ? theme::knobWidth - 4 : theme::knobWidth;
    m_painter.setPen(QPen(theme::well, theme::outline));
    m_painter.setBrush(m_state.isHovered ? theme::accent : theme::text);
    m_painter.drawRoundedRect(QRectF(middle.x() - width / 2, middle.y() - knobHeight / 2, width, knobHeight), width / 2,
                              width / 2);
    if (look.isChosen || m_state.isHovered)
        paintOutline(m_state.isHovered ? theme::accent : theme::chosen);
}

void ItemPainter::operator()(const SwatchLook& look) const
{
    const double inset = (look.isChosen ? 10 : theme::outline) + (m_state.isPressed ? 6 : 0);
    m_painter.setPen(QPen(theme::rim, theme::outline));
    m_painter.setBrush(QColor(look.color.r, look.color.g, look.color.b));
    m_painter.drawRoundedRect(box(m_area, inset), theme::itemCorner, theme::itemCorner);
    if (look.isChosen) {
        m_painter.setPen(QPen(theme::text, theme::outline));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRoundedRect(box(m_area, theme::outline / 2), theme::itemCorner, theme::itemCorner);
    }
    if (m_state.isHovered)
        paintOutline();
}

void ItemPainter::operator()(const TileLook& look) const
{
    paintGround(look.isChosen, false);
    const QRectF inside = box(m_area, 10),
                 place(inside.left(), inside.top(), inside.width(), inside.height() - nameHeight);
    if (look.picture.isNull()) {
        paintIcon(look.icon, {place.center().x() - uprightIcon / 2, place.center().y() - uprightIcon / 2, uprightIcon,
                              uprightIcon});
    } else {
        const QSizeF size = QSizeF(look.picture.size()).scaled(place.size(), Qt::KeepAspectRatio);
        const QRectF target(place.center() - QPointF(size.width(), size.height()) / 2, size);
        const QSize pixels = m_painter.transform().mapRect(target).size().toSize();
        m_painter.drawImage(target, look.picture.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    const TextStyle style{
        .height = theme::bodyHeight, .minHeight = theme::minHeight, .cut = Qt::ElideMiddle, .weight = QFont::Medium};
    paintLines(fitted(look.name, inside.width(), style), {inside.left(), place.bottom(), inside.width(), nameHeight},
               Qt::AlignCenter, theme::text);
}

void ItemPainter::operator()(const WellLook&) const
{
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(theme::well);
    m_painter.drawRoundedRect(m_area, theme::itemCorner + 4, theme::itemCorner + 4);
}

void ItemPainter::paintGround(bool isChosen, bool isFlat) const
{
    const bool isSeen = isChosen || !isFlat || m_state.isHovered;
    if (!isSeen)
        return;
    const QColor color = m_state.isPressed   ? (isChosen ? theme::chosenPressed : theme::fieldPressed)
                         : m_state.isHovered ? (isChosen ? theme::chosenHovered : theme::fieldHovered)
                                             : (isChosen ? theme::chosen : theme::field);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(color);
    m_painter.drawRoundedRect(m_area, theme::itemCorner, theme::itemCorner);
    if (m_state.isHovered)
        paintOutline();
}

void ItemPainter::paintOutline(const QColor& color) const
{
    m_painter.setPen(QPen(color, theme::outline));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawRoundedRect(box(m_area, theme::outline / 2), theme::itemCorner, theme::itemCorner);
}

/// Paints lines of text. The capitals of each line are centred vertically in the line's share of the height.
void ItemPainter::paintLines(const FittedText& text, const QRectF& area, Qt::Alignment alignment,
                             const QColor& color) const
{
    const QFontMetricsF metrics(text.font);
    const double spacing = text.lineSpacing();
    m_painter.setFont(text.font);
    m_painter.setPen(color);
    double middle = area.center().y() - spacing * (static_cast<double>(text.lines.size()) - 1) / 2;
    for (const QString& line : text.lines) {
        const double free = area.width() - metrics.horizontalAdvance(line);
        const double x = area.left() + (alignment & Qt::AlignRight     ? free
                                        : alignment & Qt::AlignHCenter ? free / 2
                                                                       : 0);
        m_painter.drawText(QPointF(x, middle + metrics.capHeight() / 2), line);
        middle += spacing;
    }
}

void ItemPainter::paintIcon(const QString& name, const QRectF& area) const
{
    const double pixels = m_painter.transform().mapRect(area).width();
    m_painter.drawImage(area, iconPicture(name, theme::text, static_cast<int>(std::lround(pixels))));
}

/// Paints the ring around the icon of an item that must be held. It fills clockwise from the top.
void ItemPainter::paintRing(const QRectF& icon) const
{
    const QRectF ring = box(icon, -ringGap);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(theme::faint, ringWidth / 2));
    m_painter.drawEllipse(ring);
    m_painter.setPen(QPen(theme::accent, ringWidth, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawArc(ring, fullCircle / 4, -static_cast<int>(std::lround(m_state.held * fullCircle)));
}

void ItemPainter::paintBar(const SliderLook& look, const QLineF& track, double share) const
{
    const double height = look.first.isValid() ? colorBarHeight : barHeight;
    const QRectF bar =
        QRectF(track.x1(), track.y1() - height / 2, track.dx(), height).adjusted(-height / 4, 0, height / 4, 0) &
        m_area;
    const double round = std::min(theme::itemCorner, height / 2);
    m_painter.setPen(Qt::NoPen);
    if (look.first.isValid()) {
        QLinearGradient gradient(track.p1(), track.p2());
        gradient.setColorAt(0, look.first);
        gradient.setColorAt(1, look.last);
        m_painter.setPen(QPen(theme::rim, theme::outline / 2));
        m_painter.setBrush(gradient);
        m_painter.drawRoundedRect(bar, round, round);
        return;
    }
    m_painter.setBrush(theme::well);
    m_painter.drawRoundedRect(bar, round, round);
    const double from = track.pointAt(sliderShare(look, look.origin)).x(), to = track.pointAt(share).x();
    QPainterPath filled, whole;
    whole.addRoundedRect(bar, round, round);
    const bool fromEnd = look.origin <= look.min;
    filled.addRect(QRectF(QPointF(fromEnd ? bar.left() : std::min(from, to), bar.top()),
                          QPointF(std::max(from, to), bar.bottom())));
    m_painter.setBrush(theme::chosen);
    m_painter.drawPath(whole & filled);
    if (!fromEnd)
        m_painter.fillRect(QRectF(from - 1.5, bar.top() - 8, 3, height + 16), theme::faint);
}
} // namespace

void paintItem(QPainter& painter, const PanelItem& item, const ItemState& state)
{
    painter.save();
    painter.setClipRect(item.area);
    painter.setOpacity(state.isEnabled ? 1 : theme::dimmed);
    std::visit(ItemPainter(painter, item, state), item.look);
    painter.restore();
}
} // namespace vr
