#include "ui/viewport/view_actions.h"

#include "ui/actions/actions.h"
#include "ui/viewport/keyboard_cursor.h"
#include "ui/viewport/viewport.h"

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
constexpr double turnStep = 15;   ///< degrees
constexpr double zoomStep = 0.87; ///< factor on the distance, as for one notch of the mouse wheel

struct TurnAction
{
    const char* id;
    double right, down;
};
constexpr TurnAction turnActions[] = {{"view.turnLeft", -turnStep, 0},
                                      {"view.turnRight", turnStep, 0},
                                      {"view.turnUp", 0, -turnStep},
                                      {"view.turnDown", 0, turnStep}};

constexpr SideAction sideActions[] = {
    {"view.front", OrbitCamera::Side::Front}, {"view.back", OrbitCamera::Side::Back},
    {"view.right", OrbitCamera::Side::Right}, {"view.left", OrbitCamera::Side::Left},
    {"view.top", OrbitCamera::Side::Top},     {"view.bottom", OrbitCamera::Side::Bottom}};
/// Zooms towards the keyboard cursor if it is on, else towards the centre of the view.
void zoomByKey(Viewport* viewport, double factor)
{
    const KeyboardCursor* cursor = viewport->keyboardCursor();
    viewport->navigation()->zoom(factor, cursor->isOn() ? std::optional(cursor->at()) : std::nullopt);
}
} // namespace

void connectView(const Actions& actions, Viewport* viewport)
{
    using Projection = OrbitCamera::Projection;
    ViewNavigation* navigation = viewport->navigation();
    const auto action = [&](const char* id) { return actions.get(QLatin1StringView(id)); };
    QObject::connect(action("view.frame"), &QAction::triggered, navigation, &ViewNavigation::frame);
    for (const SideAction& row : sideActions)
        QObject::connect(action(row.id), &QAction::triggered, navigation,
                         [navigation, side = row.side] { navigation->turnTo(side); });
    for (const TurnAction& row : turnActions)
        QObject::connect(action(row.id), &QAction::triggered, navigation,
                         [navigation, row] { navigation->turn(row.right, row.down); });
    QObject::connect(action("view.nearer"), &QAction::triggered, viewport,
                     [viewport] { zoomByKey(viewport, zoomStep); });
    QObject::connect(action("view.farther"), &QAction::triggered, viewport,
                     [viewport] { zoomByKey(viewport, 1 / zoomStep); });
    QObject::connect(action("view.orthographic"), &QAction::toggled, navigation, [navigation](bool on) {
        navigation->setProjection(on ? Projection::Orthographic : Projection::Perspective);
    });
}
} // namespace ui
