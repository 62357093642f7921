#include "ui/drawing/drawing_painter.h"

#include "ui/util/number_format.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <numeric>

namespace ui
{
namespace
{
using core::DrawnSide;

struct LayoutText
{
    Q_DECLARE_TR_FUNCTIONS(ui::DrawingLayout)

public:
    static QString name(DrawnSide side)
    {
        const QString names[] = {tr("Front"), tr("Right"), tr("Top")};
        static_assert(std::size(names) == core::drawnSides.size());
        return names[static_cast<std::size_t>(side)];
    }
};

/// Units: heights of the text. Space above a view for its caption; space beside a view with a dimension; distance of
/// the dimension line from the view; space beside a view without a dimension; length and width of the arrows.
constexpr double captionSpace = 1.6, dimensionSpace = 2.0, dimensionAt = 1.5, plainSpace = 0.6, arrowLength = 0.5,
                 arrowWidth = 0.16;

QPainterPath pathOf(const std::vector<core::DrawnLine>& lines)
{
    QPainterPath path;
    for (const core::DrawnLine& line : lines) {
        QPolygonF points;
        points.reserve(static_cast<qsizetype>(line.size()));
        for (const core::Vec2f& p : line)
            points << QPointF(static_cast<double>(p.x()), static_cast<double>(p.y()));
        path.addPolygon(points);
    }
    return path;
}

QPen penFor(const QColor& color, double width)
{
    return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

QRectF boxOf(const core::DrawnView& view)
{
    const Eigen::Vector2d low = view.box.min().cast<double>(), size = view.box.sizes().cast<double>();
    return {low.x(), low.y(), size.x(), size.y()};
}
} // namespace

DrawingLayout::DrawingLayout(const core::LineDrawing& drawing, const DrawingSettings& options,
                             const DrawingStyle& style, Arrangement arrangement)
    : m_drawing(&drawing)
    , m_options(options)
    , m_style(style)
    , m_text(QFontMetricsF(style.font).height())
{
    const bool dimensions = options.dimensions;
    switch (options.sides) {
    case DrawnSides::Front:
        m_cells = {{DrawnSide::Front, 0, 0, dimensions, dimensions}};
        break;
    case DrawnSides::Right:
        m_cells = {{DrawnSide::Right, 0, 0, dimensions, dimensions}};
        break;
    case DrawnSides::Top:
        m_cells = {{DrawnSide::Top, 0, 0, dimensions, dimensions}};
        break;
    case DrawnSides::All:
        if (arrangement == Arrangement::Projection)
            m_cells = {{DrawnSide::Top, 0, 0, false, false},
                       {DrawnSide::Front, 0, 1, dimensions, dimensions},
                       {DrawnSide::Right, 1, 1, dimensions, false}};
        else if (arrangement == Arrangement::Row)
            m_cells = {{DrawnSide::Front, 0, 0, dimensions, dimensions},
                       {DrawnSide::Right, 1, 0, dimensions, false},
                       {DrawnSide::Top, 2, 0, false, false}};
        else
            m_cells = {{DrawnSide::Front, 0, 0, dimensions, dimensions},
                       {DrawnSide::Right, 0, 1, dimensions, false},
                       {DrawnSide::Top, 0, 2, false, false}};
        break;
    }
}

double DrawingLayout::left(int column) const
{
    const bool has =
        std::ranges::any_of(m_cells, [column](const Cell& cell) { return cell.column == column && cell.hasHeight; });
    return (has ? dimensionSpace : plainSpace) * m_text;
}

double DrawingLayout::below(int row) const
{
    const bool has = std::ranges::any_of(m_cells, [row](const Cell& cell) { return cell.row == row && cell.hasWidth; });
    return (has ? dimensionSpace : plainSpace) * m_text;
}

double DrawingLayout::above() const
{
    return captionSpace * m_text;
}

std::vector<double> DrawingLayout::columnWidths(double scale) const
{
    std::vector<double> widths;
    for (const Cell& cell : m_cells) {
        widths.resize(std::max(widths.size(), static_cast<std::size_t>(cell.column) + 1), 0.0);
        double& width = widths[static_cast<std::size_t>(cell.column)];
        width = std::max(width,
                         left(cell.column) + scale * boxOf(m_drawing->view(cell.side)).width() + plainSpace * m_text);
    }
    return widths;
}

std::vector<double> DrawingLayout::rowHeights(double scale) const
{
    std::vector<double> heights;
    for (const Cell& cell : m_cells) {
        heights.resize(std::max(heights.size(), static_cast<std::size_t>(cell.row) + 1), 0.0);
        double& height = heights[static_cast<std::size_t>(cell.row)];
        height = std::max(height, above() + scale * boxOf(m_drawing->view(cell.side)).height() + below(cell.row));
    }
    return heights;
}

QSizeF DrawingLayout::sizeAt(double scale) const
{
    const auto widths = columnWidths(scale), heights = rowHeights(scale);
    return {std::accumulate(widths.begin(), widths.end(), 0.0), std::accumulate(heights.begin(), heights.end(), 0.0)};
}

double DrawingLayout::scaleFor(const QSizeF& available) const
{
    const QSizeF margins = sizeAt(0), grown = sizeAt(1) - margins;
    if (m_drawing->box.isEmpty() || grown.isEmpty())
        return 0;
    return std::max(0.0, std::min((available.width() - margins.width()) / grown.width(),
                                  (available.height() - margins.height()) / grown.height()));
}

void DrawingLayout::paint(QPainter& painter, const QPointF& centre, double scale) const
{
    if (m_drawing->box.isEmpty())
        return;
    const auto widths = columnWidths(scale), heights = rowHeights(scale);
    const QSizeF size = sizeAt(scale);
    const QPointF corner = centre - QPointF(size.width(), size.height()) / 2;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setFont(m_style.font);
    for (const Cell& cell : m_cells) {
        const double x = std::accumulate(widths.begin(), widths.begin() + cell.column, left(cell.column));
        const double bottom = std::accumulate(heights.begin(), heights.begin() + cell.row + 1, -below(cell.row));
        paintView(painter, cell, corner + QPointF(x, bottom), scale);
    }
}

void DrawingLayout::paintView(QPainter& painter, const Cell& cell, const QPointF& bottomLeft, double scale) const
{
    const QSizeF size = boxOf(m_drawing->view(cell.side)).size() * scale;
    const QRectF view(bottomLeft - QPointF(0, size.height()), size);
    paintLines(painter, cell, bottomLeft, scale);
    painter.setPen(m_style.faint);
    painter.drawText(QPointF(view.left(), view.top() - 0.5 * m_text), LayoutText::name(cell.side));
    paintDimensions(painter, cell, view);
}

/// Paints a view's lines and shading. Transforms the painter to mm of the model, y upwards.
void DrawingLayout::paintLines(QPainter& painter, const Cell& cell, const QPointF& bottomLeft, double scale) const
{
    const core::DrawnView& view = m_drawing->view(cell.side);
    painter.save();
    painter.translate(bottomLeft);
    painter.scale(scale, -scale);
    painter.translate(-boxOf(view).topLeft());
    if (const core::DrawnImage& shaded = view.shaded; m_options.shaded && !shaded.pixels.empty()) {
        const QImage image(shaded.pixels.front().data(), shaded.width, shaded.height, 4 * shaded.width,
                           QImage::Format_RGBA8888);
        const auto pixel = static_cast<double>(shaded.pixel);
        const QSizeF size(shaded.width * pixel, shaded.height * pixel);
        painter.save();
        painter.translate(static_cast<double>(shaded.topLeft.x()), static_cast<double>(shaded.topLeft.y()));
        painter.scale(1, -1);
        painter.drawImage(QRectF({}, size), image);
        painter.restore();
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penFor(m_style.ink, m_style.line / 2 / scale));
    painter.drawPath(pathOf(view.creases));
    painter.setPen(penFor(m_style.ink, m_style.line / scale));
    painter.drawPath(pathOf(view.outlines));
    painter.restore();
}

void DrawingLayout::paintDimensions(QPainter& painter, const Cell& cell, const QRectF& view) const
{
    const QRectF box = boxOf(m_drawing->view(cell.side));
    painter.setPen(penFor(m_style.faint, m_style.line / 2));
    const double clear = 0.2 * m_text, at = dimensionAt * m_text, beyond = at + 0.2 * m_text;
    if (cell.hasWidth) {
        for (const QPointF& corner : {view.bottomLeft(), view.bottomRight()})
            painter.drawLine(corner + QPointF(0, clear), corner + QPointF(0, beyond));
        paintDimension(painter, view.bottomLeft() + QPointF(0, at), view.bottomRight() + QPointF(0, at), box.width());
    }
    if (cell.hasHeight) {
        for (const QPointF& corner : {view.topLeft(), view.bottomLeft()})
            painter.drawLine(corner - QPointF(clear, 0), corner - QPointF(beyond, 0));
        paintDimension(painter, view.bottomLeft() - QPointF(at, 0), view.topLeft() - QPointF(at, 0), box.height());
    }
}

/// Paints a dimension: a line with an arrow at each end, and the length above it. `value`: mm.
void DrawingLayout::paintDimension(QPainter& painter, const QPointF& from, const QPointF& to, double value) const
{
    painter.save();
    painter.translate(from);
    painter.rotate(-QLineF(from, to).angle());
    const double length = QLineF(from, to).length(), arrow = std::min(arrowLength * m_text, length / 3),
                 width = arrowWidth * m_text;
    painter.drawLine(QPointF(0, 0), QPointF(length, 0));
    for (const double sign : {1.0, -1.0}) {
        const double tip = sign > 0 ? 0 : length;
        painter.drawPolyline(QPolygonF{{tip + sign * arrow, -width}, {tip, 0}, {tip + sign * arrow, width}});
    }
    const QString text = LayoutText::tr("%1 mm").arg(millimetres(value));
    const double textWidth = QFontMetricsF(m_style.font).horizontalAdvance(text);
    painter.drawText(QPointF((length - textWidth) / 2, -0.25 * m_text), text);
    painter.restore();
}

DrawingLayout bestLayout(const core::LineDrawing& drawing, const DrawingSettings& options, const DrawingStyle& style,
                         const QSizeF& available)
{
    using Arrangement = DrawingLayout::Arrangement;
    DrawingLayout best(drawing, options, style, Arrangement::Projection);
    for (const Arrangement arrangement : {Arrangement::Row, Arrangement::Column})
        if (DrawingLayout other(drawing, options, style, arrangement);
            other.scaleFor(available) > 1.1 * best.scaleFor(available))
            best = std::move(other);
    return best;
}
} // namespace ui
