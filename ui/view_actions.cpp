#include "view_actions.h"

#include "actions.h"
#include "viewport.h"

#include <QAction>

namespace ui
{
namespace
{
struct SideAction
{
    const char* id;
    OrbitCamera::Side side;
};
constexpr SideAction sideActions[] = {
    {"view.front", OrbitCamera::Side::Front}, {"view.back", OrbitCamera::Side::Back},
    {"view.right", OrbitCamera::Side::Right}, {"view.left", OrbitCamera::Side::Left},
    {"view.top", OrbitCamera::Side::Top},     {"view.bottom", OrbitCamera::Side::Bottom}};
} // namespace

void connectView(const Actions& actions, Viewport* viewport)
{
    using Projection = OrbitCamera::Projection;
    const auto action = [&](const char* id) { return actions.get(QLatin1StringView(id)); };
    QObject::connect(action("view.frame"), &QAction::triggered, viewport, &Viewport::frame);
    for (const SideAction& row : sideActions)
        QObject::connect(action(row.id), &QAction::triggered, viewport,
                         [viewport, side = row.side] { viewport->turnTo(side); });
    QObject::connect(action("view.orthographic"), &QAction::toggled, viewport, [viewport](bool on) {
        viewport->setProjection(on ? Projection::Orthographic : Projection::Perspective);
    });
}
} // namespace ui
