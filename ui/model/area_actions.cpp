#include "ui/model/area_actions.h"

#include "ui/actions/actions.h"
#include "ui/settings/brush_settings.h"
#include "ui/viewport/curve_drawing.h"
#include "ui/viewport/viewport.h"

#include <QAction>

#include <optional>
#include <utility>

namespace ui
{
namespace
{
constexpr std::pair<const char*, AreaUse> areaActions[] = {{"area.mask", AreaUse::Mask},
                                                           {"area.unmask", AreaUse::Unmask},
                                                           {"area.hide", AreaUse::Hide},
                                                           {"area.trim", AreaUse::Trim},
                                                           {"area.split", AreaUse::Split}};

/// Returns the area of a curve in the view, in logical pixels. The curve is placed at the depth of the view's target.
core::ViewArea areaOf(const QPolygonF& curve, const OrbitCamera& camera)
{
    core::ViewArea area;
    area.direction = camera.viewDirection();
    if (camera.projection() == OrbitCamera::Projection::Perspective)
        area.eye = camera.eye();
    for (const QPointF& pixel : curve) {
        const core::Ray ray = camera.ray({pixel.x(), pixel.y()});
        const double away = (camera.target() - ray.origin).dot(area.direction) / ray.direction.dot(area.direction);
        area.outline.push_back(ray.origin + away * ray.direction);
    }
    return area;
}

core::ModelCommand commandFor(AreaUse use, const core::ViewArea& area, const std::optional<core::Rgb>& color)
{
    switch (use) {
    case AreaUse::Mask:
        return core::MaskArea{area};
    case AreaUse::Unmask:
        return core::MaskArea{area, true};
    case AreaUse::Hide:
        return core::HideArea{area};
    case AreaUse::Trim:
        break;
    case AreaUse::Split:
        return core::SplitPart{area, {}};
    }
    return core::Trim{area, color};
}
} // namespace

CurveDrawing* connectAreas(const Actions& actions, Viewport* viewport, const BrushSettings* brush,
                           const std::function<void(const core::ModelCommand&)>& request)
{
    auto* drawing = new CurveDrawing(viewport);
    for (const auto& [id, use] : areaActions)
        QObject::connect(actions.get(QLatin1StringView(id)), &QAction::triggered, drawing,
                         [drawing, use = use] { drawing->begin(use); });
    QObject::connect(drawing, &CurveDrawing::drawn, viewport, [=](const DrawnArea& drawn) {
        core::ViewArea area = areaOf(drawn.curve, viewport->camera());
        area.side = drawn.isOutside ? core::ViewArea::Side::Outside : core::ViewArea::Side::Inside;
        area.isFrontOnly = drawn.isFrontOnly;
        const core::StrokeSettings stroke = brush->stroke();
        area.symmetry = stroke.symmetry;
        request(commandFor(drawn.use, area, drawn.isColored ? std::optional(stroke.color) : std::nullopt));
    });
    return drawing;
}
} // namespace ui
