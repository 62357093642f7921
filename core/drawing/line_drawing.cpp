#include "core/drawing/line_drawing.h"

#include "core/drawing/projected_views.h"

namespace core
{
Vec3f onPaper(DrawnSide side, const Vec3f& point)
{
    switch (side) {
    case DrawnSide::Front:
        return point;
    case DrawnSide::Right:
        return {-point.z(), point.y(), point.x()};
    case DrawnSide::Top:
        return {point.x(), -point.z(), point.y()};
    }
    return point;
}

std::optional<LineDrawing> drawLines(const DrawArrays& model, const DrawingDetail& detail, const std::stop_token& stop)
{
    FeatureScan scan(detail.maxEdges);
    if (!scan.scan(model, stop))
        return std::nullopt;
    const Box box = scan.box();
    if (box.isEmpty())
        return LineDrawing();
    DepthImages images = depthImagesOf(box, static_cast<float>(box.sizes().maxCoeff() / detail.pixels));
    return drawingOf(model, scan, images, detail.shaded, stop);
}
} // namespace core
