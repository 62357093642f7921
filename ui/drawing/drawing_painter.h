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
/// Pens and font of a drawing. Units: the painter's.
struct DrawingStyle
{
    QColor ink, faint; ///< colour of lines; colour of text and dimensions
    double line = 1.5; ///< width of outlines; creases have half this width
    QFont font;        ///< font of the text; its size must be set in pixels
};

/// The layout of a drawing's views on a sheet or in a panel: by default the top view above the front view and the right
/// view beside it, each with its name. Dimensions are optional. Precondition: the drawing outlives the layout. Thread:
/// any.
class DrawingLayout
{
public:
    enum class Arrangement { Projection, Row, Column };

    /// Row and Column arrange the views side by side, or one below the other.
    DrawingLayout(const core::LineDrawing& drawing, const DrawingSettings& options, const DrawingStyle& style,
                  Arrangement arrangement);

    /// Returns the largest scale at which the layout fits, in painter units for each mm; 0: it fits at no scale.
    double scaleFor(const QSizeF& available) const;
    QSizeF sizeAt(double scale) const;
    /// Paints the layout antialiased, centred at `centre`.
    void paint(QPainter& painter, const QPointF& centre, double scale) const;

private:
    struct Cell
    {
        core::DrawnSide side;
        int column, row;
        bool hasWidth, hasHeight; ///< the dimension of this side is drawn
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
    double m_text; ///< height of the font, painter units
    std::vector<Cell> m_cells;
};

/// Returns the layout with the arrangement that shows the drawing largest.
DrawingLayout bestLayout(const core::LineDrawing& drawing, const DrawingSettings& options, const DrawingStyle& style,
                         const QSizeF& available);
} // namespace ui
