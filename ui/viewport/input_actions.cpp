#include "ui/viewport/input_actions.h"

#include "ui/actions/actions.h"
#include "ui/settings/settings.h"
#include "ui/viewport/brush_drag.h"
#include "ui/viewport/turntable.h"
#include "ui/viewport/turntable_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/side_dock.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

namespace ui
{
namespace
{
struct HandActions
{
    Q_DECLARE_TR_FUNCTIONS(ui::HandActions)
};

void connectDrags(const Actions& actions, BrushSettings* brush, Viewport* viewport)
{
    auto* drag = new BrushDrag(brush, viewport);
    const auto connectTo = [&](const char* id, core::Parameter parameter) {
        QAction* action = actions.get(QLatin1StringView(id));
        action->setAutoRepeat(false);
        QObject::connect(action, &QAction::triggered, drag, [drag, parameter] { drag->begin(parameter); });
    };
    connectTo("brush.radius", core::Parameter::Radius);
    connectTo("brush.strength", core::Parameter::Strength);
}

void connectSteady(QAction* action, BrushSettings* brush, Settings* settings)
{
    const auto takeUp = [=] {
        brush->setSteady(settings->isSteady());
        brush->setStringLength(settings->stringLength());
    };
    takeUp();
    settings->onReset(takeUp);
    const auto show = [=] { action->setChecked(brush->isSteady()); };
    QObject::connect(action, &QAction::triggered, brush, &BrushSettings::setSteady);
    QObject::connect(brush, &BrushSettings::changed, action, show);
    QObject::connect(brush, &BrushSettings::handChanged, action, [=] {
        settings->setSteady(brush->isSteady());
        settings->setStringLength(brush->stringLength());
    });
    show();
}
void connectAdding(QAction* action, const HandPlace& place)
{
    QObject::connect(action, &QAction::triggered, place.viewport,
                     [viewport = place.viewport, notice = place.notice](bool adds) {
                         viewport->setAdding(adds);
                         if (adds)
                             notice(HandActions::tr("Click where the ball should be. Esc puts it away."));
                     });
    QObject::connect(place.viewport, &Viewport::addingChanged, action, &QAction::setChecked);
}

void connectKeys(QAction* action, const HandPlace& place)
{
    QObject::connect(
        action, &QAction::triggered, place.viewport, [viewport = place.viewport, notice = place.notice](bool on) {
            viewport->setKeyHand(on);
            if (on)
                notice(HandActions::tr(
                    "Arrow keys move the cross. Space presses while it is held, Return until the next Return."));
        });
    QObject::connect(place.viewport, &Viewport::keyHandChanged, action, &QAction::setChecked);
}

void connectInvert(QAction* action, BrushSettings* brush)
{
    QObject::connect(action, &QAction::triggered, brush, &BrushSettings::setTurnedRound);
    QObject::connect(brush, &BrushSettings::changed, action, [=] { action->setChecked(brush->isTurnedRound()); });
}

void connectTurntable(QAction* action, const HandPlace& place, Settings* settings)
{
    auto* turntable = new TurntableMotor(place.viewport);
    const auto takeUp = [=] {
        turntable->setSpeed(settings->turnSpeed());
        turntable->setClockwise(settings->turnsClockwise());
    };
    takeUp();
    settings->onReset(takeUp);
    QObject::connect(turntable, &TurntableMotor::turned, place.viewport, &Viewport::turnModel);
    QObject::connect(action, &QAction::triggered, turntable, &TurntableMotor::setOn);
    QObject::connect(turntable, &TurntableMotor::changed, action, [=] {
        action->setChecked(turntable->isOn());
        settings->setTurnSpeed(turntable->speed());
        settings->setTurnsClockwise(turntable->isClockwise());
    });
    addSideDock(place.window, place.toggles, makeTurntablePanel(turntable), QStringLiteral("topologyPanel"));
}
} // namespace

void connectHand(const HandPlace& place, BrushSettings* brush, Settings* settings, const Actions& actions)
{
    connectDrags(actions, brush, place.viewport);
    connectSteady(actions.get(QStringLiteral("brush.steady")), brush, settings);
    connectInvert(actions.get(QStringLiteral("brush.invert")), brush);
    connectKeys(actions.get(QStringLiteral("brush.keys")), place);
    connectAdding(actions.get(QStringLiteral("brush.add")), place);
    connectTurntable(actions.get(QStringLiteral("turntable.on")), place, settings);
}
} // namespace ui
