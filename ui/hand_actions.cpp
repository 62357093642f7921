#include "hand_actions.h"

#include "actions.h"
#include "brush_drag.h"
#include "settings.h"
#include "viewport.h"

#include <QAction>

namespace ui
{
namespace
{
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
} // namespace

void connectHand(const Actions& actions, BrushSettings* brush, Viewport* viewport, Settings* settings)
{
    connectDrags(actions, brush, viewport);
    connectSteady(actions.get(QStringLiteral("brush.steady")), brush, settings);
}
} // namespace ui
