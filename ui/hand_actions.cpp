#include "hand_actions.h"

#include "actions.h"
#include "brush_drag.h"
#include "settings.h"
#include "viewport.h"

#include <QAction>
#include <QCoreApplication>

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
    brush->setSteady(settings->isSteady());
    brush->setStringLength(settings->stringLength());
    const auto show = [=] { action->setChecked(brush->isSteady()); };
    QObject::connect(action, &QAction::triggered, brush, &BrushSettings::setSteady);
    QObject::connect(brush, &BrushSettings::changed, action, show);
    QObject::connect(brush, &BrushSettings::handChanged, action, [=] {
        settings->setSteady(brush->isSteady());
        settings->setStringLength(brush->stringLength());
    });
    show();
}
void connectAdding(QAction* action, Viewport* viewport, const Say& say)
{
    QObject::connect(action, &QAction::triggered, viewport, [viewport, say](bool adds) {
        viewport->setAdding(adds);
        if (adds)
            say(HandActions::tr("Click where the ball should be. Esc puts it away."));
    });
    QObject::connect(viewport, &Viewport::addingChanged, action, &QAction::setChecked);
}
} // namespace

void connectHand(const Actions& actions, BrushSettings* brush, Viewport* viewport, Settings* settings, const Say& say)
{
    connectAdding(actions.get(QStringLiteral("brush.add")), viewport, say);
    connectDrags(actions, brush, viewport);
    connectSteady(actions.get(QStringLiteral("brush.steady")), brush, settings);
}
} // namespace ui
