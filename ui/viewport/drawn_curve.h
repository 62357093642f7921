#pragma once

#include <QPolygonF>

namespace ui
{
/// Ways of drawing a closed curve over the view.
enum class CurveShape {
    Lasso,  ///< follows the pointer
    Box,    ///< upright rectangle between two corners
    Line,   ///< everything on the right of a line, in the direction in which it is drawn
    Polygon ///< straight lines between clicks
};

/// Uses of an area of the view.
enum class AreaUse { Mask, Unmask, Hide, Trim, Split };

/// An area that was drawn over the view.
struct DrawnArea
{
    AreaUse use = AreaUse::Mask;
    QPolygonF curve;          ///< closed; corners in the view, logical pixels
    bool isOutside = false;   ///< what is beside the curve counts
    bool isFrontOnly = false; ///< only what is seen first counts
    bool isColored = false;   ///< a cut gets the paint colour
};

/// Returns the closed curve between two places of the pointer. Precondition: the shape is Box or Line. `view`: the size
/// of the view; a line's curve reaches far beyond it. Empty if it has no area. Units: logical pixels.
QPolygonF curveBetween(CurveShape shape, const QPointF& from, const QPointF& to, const QSizeF& view);

/// Returns the curve without the points that are at most `tolerance` (pixels) from the line through those that remain
/// (Douglas and Peucker 1973). A mouse tells whole pixels, so the points of a straight line are up to a pixel from the
/// line through two of them; with a tolerance below 1 the curve would have steps. First and last point remain. Cost:
/// as core::simplifiedPath().
QPolygonF simplified(const QPolygonF& curve, double tolerance = 1);
} // namespace ui
