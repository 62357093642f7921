#pragma once

#include "ui/settings/drawing_settings.h"

#include "core/drawing/line_drawing.h"

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QSizeF>

#include <vector>

class QPainter;

namespace ui
{
/// Lengths are the painter's units.
struct DrawingStyle
{
    QColor ink, faint; ///< lines; words and dimensions
    double line = 1.5; ///< width of outlines; creases have half
    QFont font;        ///< with its pixel size set
};

/// How drawings stand on a sheet or in a panel: the top view above the front view, the right view beside it, each with
/// its name, and dimensions where they are asked for. Any thread; the drawing must outlive the layout.
class DrawingLayout
{
public:
    enum class Arrangement { Projection, Row, Column };

    /// In Row and Column the views stand side by side, or one below the other.
    DrawingLayout(const core::LineDrawing& drawing, const DrawingSettings& options, const DrawingStyle& style,
                  Arrangement arrangement);

    /// The largest scale, in units a mm, at which it fits; 0 if none does.
    double scaleFor(const QSizeF& available) const;
    QSizeF sizeAt(double scale) const;
    /// Antialiased, about the given centre.
    void paint(QPainter& painter, const QPointF& centre, double scale) const;

private:
    struct Cell
    {
        core::DrawnSide side;
        int column, row;
        bool hasWidth, hasHeight; ///< dimensions
    };

    double left(int column) const;
    double below(int row) const;
    double above() const;
    std::vector<double> columnWidths(double scale) const;
    std::vector<double> rowHeights(double scale) const;
    void paintView(QPainter& painter, const Cell& cell, const QPointF& bottomLeft, double scale) const;
    void paintLines(QPainter& painter, const Cell& cell, const QPointF& bottomLeft, double scale) const;
    void paintDimensions(QPainter& painter, const Cell& cell, const QRectF& view) const;
    void paintDimension(QPainter& painter, const QPointF& from, const QPointF& to, double value) const;

    const core::LineDrawing* m_drawing;
    DrawingSettings m_options;
    DrawingStyle m_style;
    double m_text; ///< height of the font
    std::vector<Cell> m_cells;
};

/// The arrangement that shows the drawing largest.
DrawingLayout bestLayout(const core::LineDrawing& drawing, const DrawingSettings& options, const DrawingStyle& style,
                         const QSizeF& available);
} // namespace ui
