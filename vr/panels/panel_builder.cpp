#include "vr/panels/panel_builder.h"

#include "vr/panels/panel_theme.h"

#include <algorithm>
#include <numeric>

namespace vr
{
namespace
{
constexpr double valueWidth = 126, wellInset = 6;
} // namespace

PanelBuilder::PanelBuilder(PanelKind kind, double width, double distance) : m_y(theme::margin)
{
    m_layout.kind = kind;
    m_layout.size.setWidth(width);
    m_layout.distance = distance;
}

PanelLayout PanelBuilder::finished() const
{
    PanelLayout layout = m_layout;
    layout.size.setHeight(m_y - theme::gap + theme::margin);
    return layout;
}

double PanelBuilder::innerWidth() const
{
    return m_layout.size.width() - 2 * theme::margin;
}

QRectF PanelBuilder::nextRow(double height)
{
    const QRectF row(theme::margin, m_y, innerWidth(), height);
    m_y += height + theme::gap;
    return row;
}

void PanelBuilder::add(const QRectF& area, const PanelButton& button)
{
    m_layout.items.push_back({area, button.look, button.action, button.isEnabled, button.mustHold});
}

void PanelBuilder::addTitle(const PanelTitle& title, const std::vector<PanelButton>& buttons)
{
    std::vector<double> widths(buttons.size() + 1, theme::titleRow);
    widths.front() = 0;
    const std::vector<QRectF> places = cells(nextRow(theme::titleRow), widths);
    const std::vector<QRectF> texts =
        title.note.isEmpty() ? std::vector{places.front()} : cells(places.front(), {title.textWidth, 0});
    add(texts.front(), TextLook{.text = title.text, .role = TextRole::Title});
    if (!title.note.isEmpty())
        add(texts.back(), TextLook{.text = title.note,
                                   .role = TextRole::Faint,
                                   .alignment = Qt::AlignRight | Qt::AlignVCenter,
                                   .lines = 2});
    for (std::size_t i = 0; i < buttons.size(); ++i)
        add(places[i + 1], buttons[i]);
}

void PanelBuilder::addChoice(const QString& name, double nameWidth, const std::vector<PanelChoice>& choices)
{
    QRectF row = nextRow(theme::row);
    if (!name.isEmpty()) {
        const std::vector<QRectF> halves = cells(row, {nameWidth, 0});
        add(halves.front(), TextLook{.text = name, .lines = 2});
        row = halves.back();
    }
    addChoice(row, choices);
}

void PanelBuilder::addChoice(const QRectF& row, const std::vector<PanelChoice>& choices)
{
    add(row, WellLook{});
    const QRectF inside = row.adjusted(wellInset, wellInset, -wellInset, -wellInset);
    const double width = inside.width() / static_cast<double>(choices.size());
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const PanelChoice& choice = choices[i];
        const QRectF place(inside.left() + static_cast<double>(i) * width, inside.top(), width, inside.height());
        add(place, PanelButton{{.text = choice.text, .icon = choice.icon, .isChosen = choice.isChosen, .isFlat = true},
                               choice.action});
    }
}

void PanelBuilder::addSwitch(const SwitchRow& row, double nameWidth)
{
    const std::vector<QRectF> places = cells(nextRow(theme::row), {nameWidth, 0});
    add(places[0], TextLook{.text = row.name, .lines = 2});
    add({places[1], row.look, row.action, row.isEnabled});
}

void PanelBuilder::addSlider(const SliderRow& row, double nameWidth)
{
    const std::vector<QRectF> places = cells(nextRow(theme::row), {nameWidth, 0, valueWidth});
    add(places[0], TextLook{.text = row.name, .lines = 2});
    add({places[1], row.look, row.slide});
    add(places[2],
        TextLook{.text = row.value, .role = TextRole::Number, .alignment = Qt::AlignRight | Qt::AlignVCenter});
}

std::vector<QRectF> cells(const QRectF& row, const std::vector<double>& widths)
{
    const double gaps = theme::gap * static_cast<double>(widths.size() - 1);
    const double rest = row.width() - gaps - std::accumulate(widths.begin(), widths.end(), 0.0);
    const auto sharers = std::ranges::count(widths, 0.0);
    std::vector<QRectF> places;
    double x = row.left();
    for (const double asked : widths) {
        const double width = asked > 0 ? asked : rest / static_cast<double>(sharers);
        places.emplace_back(x, row.top(), width, row.height());
        x += width + theme::gap;
    }
    return places;
}

std::vector<QRectF> evenCells(const QRectF& row, std::size_t count)
{
    return cells(row, std::vector<double>(count, 0.0));
}
} // namespace vr
