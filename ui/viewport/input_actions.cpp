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
struct InputActions
{
    Q_DECLARE_TR_FUNCTIONS(ui::InputActions)
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
    const auto applySettings = [=] {
        brush->setSteady(settings->isSteady());
        brush->setStabilizerLength(settings->stabilizerLength());
    };
    applySettings();
    settings->onReset(applySettings);
    const auto show = [=] { action->setChecked(brush->isSteady()); };
    QObject::connect(action, &QAction::triggered, brush, &BrushSettings::setSteady);
    QObject::connect(brush, &BrushSettings::changed, action, show);
    QObject::connect(brush, &BrushSettings::inputChanged, action, [=] {
        settings->setSteady(brush->isSteady());
        settings->setStabilizerLength(brush->stabilizerLength());
    });
    show();
}
void connectAdding(QAction* action, const InputActionsContext& context)
{
    QObject::connect(action, &QAction::triggered, context.viewport,
                     [viewport = context.viewport, notice = context.notice](bool adds) {
                         viewport->setAdding(adds);
                         if (adds)
                             notice(InputActions::tr("Click where the ball should be. Esc puts it away."));
                     });
    QObject::connect(context.viewport, &Viewport::addingChanged, action, &QAction::setChecked);
}

void connectKeyboardCursor(QAction* action, const InputActionsContext& context)
{
    QObject::connect(
        action, &QAction::triggered, context.viewport, [viewport = context.viewport, notice = context.notice](bool on) {
            viewport->setKeyboardCursor(on);
            if (on)
                notice(InputActions::tr(
                    "Arrow keys move the cross. Space presses while it is held, Return until the next Return."));
        });
    QObject::connect(context.viewport, &Viewport::keyboardCursorChanged, action, &QAction::setChecked);
}

void connectInvert(QAction* action, BrushSettings* brush)
{
    QObject::connect(action, &QAction::triggered, brush, &BrushSettings::setInverted);
    QObject::connect(brush, &BrushSettings::changed, action, [=] { action->setChecked(brush->isInverted()); });
}

void connectTurntable(QAction* action, const InputActionsContext& context, Settings* settings)
{
    auto* turntable = new Turntable(context.viewport);
    const auto applySettings = [=] {
        turntable->setSpeed(settings->turnSpeed());
        turntable->setClockwise(settings->turnsClockwise());
    };
    applySettings();
    settings->onReset(applySettings);
    QObject::connect(turntable, &Turntable::turned, context.viewport, &Viewport::turnModel);
    QObject::connect(action, &QAction::triggered, turntable, &Turntable::setOn);
    QObject::connect(turntable, &Turntable::changed, action, [=] {
        action->setChecked(turntable->isOn());
        settings->setTurnSpeed(turntable->speed());
        settings->setTurnsClockwise(turntable->isClockwise());
    });
    addSideDock(context.window, context.toggles, makeTurntablePanel(turntable), QStringLiteral("topologyPanel"));
}
} // namespace

void connectInputActions(const InputActionsContext& context, BrushSettings* brush, Settings* settings,
                         const Actions& actions)
{
    connectDrags(actions, brush, context.viewport);
    connectSteady(actions.get(QStringLiteral("brush.steady")), brush, settings);
    connectInvert(actions.get(QStringLiteral("brush.invert")), brush);
    connectKeyboardCursor(actions.get(QStringLiteral("brush.keys")), context);
    connectAdding(actions.get(QStringLiteral("brush.add")), context);
    connectTurntable(actions.get(QStringLiteral("turntable.on")), context, settings);
}
} // namespace ui
