#include "ui/viewport/input_actions.h"

#include "ui/actions/actions.h"
#include "ui/settings/settings.h"
#include "ui/viewport/brush_drag.h"
#include "ui/viewport/keyboard_cursor.h"
#include "ui/viewport/turntable.h"
#include "ui/viewport/turntable_panel.h"
#include "ui/viewport/viewport.h"

#include <QAction>
#include <QCoreApplication>

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
        brush->setSteady(settings->get(&Setting::isSteady));
        brush->setStabilizerLength(settings->get(&Setting::stabilizerLength));
    };
    applySettings();
    settings->onReset(applySettings);
    const auto show = [=] { action->setChecked(brush->isSteady()); };
    QObject::connect(action, &QAction::triggered, brush, &BrushSettings::setSteady);
    QObject::connect(brush, &BrushSettings::changed, action, show);
    QObject::connect(brush, &BrushSettings::inputChanged, action, [=] {
        settings->set(&Setting::isSteady, brush->isSteady());
        settings->set(&Setting::stabilizerLength, brush->stabilizerLength());
    });
    show();
}

void rememberAirbrush(BrushSettings* brush, Settings* settings)
{
    const auto nameOf = [](core::Tool tool) { return QString::fromUtf8(core::name(tool)); };
    const auto forEachTool = [](auto visit) {
        for (std::size_t i = 0; i < core::toolNames().size(); ++i)
            visit(static_cast<core::Tool>(i));
    };
    const auto applySettings = [=] {
        const QStringList without = settings->get(&Setting::withoutAirbrush);
        forEachTool([&](core::Tool tool) { brush->tools()->setAirbrush(tool, !without.contains(nameOf(tool))); });
    };
    applySettings();
    settings->onReset(applySettings);
    QObject::connect(brush, &BrushSettings::inputChanged, brush, [=] {
        QStringList without;
        forEachTool([&](core::Tool tool) {
            if (core::canAirbrush(tool) && !brush->tools()->isAirbrush(tool))
                without.append(nameOf(tool));
        });
        settings->set(&Setting::withoutAirbrush, without);
    });
}

/// Connects an action that is checked until the next press, to which `sentence` asks.
void connectMode(QAction* action, PointerMode mode, const QString& sentence, const InputActionsContext& context)
{
    QObject::connect(action, &QAction::triggered, context.viewport,
                     [mode, sentence, viewport = context.viewport, notice = context.notice](bool on) {
                         if (on)
                             viewport->setFocus();
                         viewport->input()->setMode(mode, on);
                         if (on)
                             notice(sentence);
                     });
    QObject::connect(context.viewport->input(), &PointerInput::modeChanged, action,
                     [action, mode](PointerMode present) { action->setChecked(present == mode); });
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
    const KeyboardCursor* cursor = context.viewport->keyboardCursor();
    QObject::connect(cursor, &KeyboardCursor::changed, action,
                     [action, cursor] { action->setChecked(cursor->isOn()); });
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
        turntable->setSpeed(settings->get(&Setting::turnSpeed));
        turntable->setClockwise(settings->get(&Setting::turnsClockwise));
    };
    applySettings();
    settings->onReset(applySettings);
    QObject::connect(turntable, &Turntable::turned, context.viewport->navigation(), &ViewNavigation::turnModel);
    QObject::connect(action, &QAction::triggered, turntable, &Turntable::setOn);
    QObject::connect(turntable, &Turntable::changed, action, [=] {
        action->setChecked(turntable->isOn());
        settings->set(&Setting::turnSpeed, turntable->speed());
        settings->set(&Setting::turnsClockwise, turntable->isClockwise());
    });
    addTurntablePanel(context.column, turntable);
}
} // namespace

void connectInputActions(const InputActionsContext& context, BrushSettings* brush, Settings* settings,
                         const Actions& actions)
{
    connectDrags(actions, brush, context.viewport);
    connectSteady(actions.get(QStringLiteral("brush.steady")), brush, settings);
    rememberAirbrush(brush, settings);
    connectInvert(actions.get(QStringLiteral("brush.invert")), brush);
    connectKeyboardCursor(actions.get(QStringLiteral("brush.keys")), context);
    connectMode(actions.get(QStringLiteral("brush.add")), PointerMode::Add,
                InputActions::tr("Click to place the ball. Esc cancels."), context);
    connectMode(actions.get(QStringLiteral("parts.choose")), PointerMode::ChoosePart,
                InputActions::tr("Click the part that is to be active. Esc cancels."), context);
    connectTurntable(actions.get(QStringLiteral("turntable.on")), context, settings);
}
} // namespace ui
