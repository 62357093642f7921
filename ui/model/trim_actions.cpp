#include "ui/model/trim_actions.h"

#include "ui/actions/actions.h"
#include "ui/settings/brush_settings.h"
#include "ui/viewport/curve_drawing.h"
#include "ui/viewport/viewport.h"

#include <QAction>

#include <utility>

namespace ui
{
namespace
{
constexpr std::pair<const char*, CurveShape> trimActions[] = {{"trim.lasso", CurveShape::Lasso},
                                                              {"trim.box", CurveShape::Box},
                                                              {"trim.line", CurveShape::Line},
                                                              {"trim.polygon", CurveShape::Polygon}};

/// Returns the cut along a curve in the view, in logical pixels. The curve is placed at the depth of the view's target.
core::Trim trimAlong(const QPolygonF& curve, const OrbitCamera& camera)
{
    core::Trim trim;
    trim.direction = camera.viewDirection();
    if (camera.projection() == OrbitCamera::Projection::Perspective)
        trim.eye = camera.eye();
    for (const QPointF& pixel : curve) {
        const core::Ray ray = camera.ray({pixel.x(), pixel.y()});
        const double away = (camera.target() - ray.origin).dot(trim.direction) / ray.direction.dot(trim.direction);
        trim.outline.push_back(ray.origin + away * ray.direction);
    }
    return trim;
}
} // namespace

void connectTrim(const Actions& actions, Viewport* viewport, const BrushSettings* brush,
                 const std::function<void(const core::ModelCommand&)>& request)
{
    auto* drawing = new CurveDrawing(viewport);
    for (const auto& [id, shape] : trimActions)
        QObject::connect(actions.get(QLatin1StringView(id)), &QAction::triggered, drawing,
                         [drawing, shape = shape] { drawing->begin(shape); });
    QObject::connect(drawing, &CurveDrawing::drawn, viewport, [=](const QPolygonF& curve, bool isOutside) {
        core::Trim trim = trimAlong(curve, viewport->camera());
        trim.remove = isOutside ? core::Trim::Remove::Outside : core::Trim::Remove::Inside;
        trim.symmetry = brush->stroke().symmetry;
        request(trim);
    });
}
} // namespace ui
