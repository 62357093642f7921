#include "ui/brush/brush_actions.h"

#include "ui/actions/actions.h"
#include "ui/settings/brush_settings.h"

#include <QAction>
#include <QActionGroup>

namespace ui
{
namespace
{
constexpr double smallerRadius = 0.9;

struct ToolAction
{
    const char* id;
    core::Tool tool;
};
constexpr ToolAction toolActions[] = {
    {"tool.pull", core::Tool::Pull},     {"tool.push", core::Tool::Push},     {"tool.inflate", core::Tool::Inflate},
    {"tool.clay", core::Tool::Clay},     {"tool.layer", core::Tool::Layer},   {"tool.flatten", core::Tool::Flatten},
    {"tool.scrape", core::Tool::Scrape}, {"tool.smooth", core::Tool::Smooth}, {"tool.pinch", core::Tool::Pinch},
    {"tool.crease", core::Tool::Crease}, {"tool.grab", core::Tool::Grab},     {"tool.snake", core::Tool::SnakeHook},
    {"tool.twist", core::Tool::Twist},   {"tool.stamp", core::Tool::Stamp},   {"tool.paint", core::Tool::Paint},
    {"tool.mask", core::Tool::Mask}};

/// Connects a checkable action to a setting: checked means `on`, unchecked means `off`.
template <class T> void connectChoice(QAction* action, BrushSettings* brush, T core::StrokeSettings::*what, T on, T off)
{
    const auto show = [=] { action->setChecked(brush->stroke().*what == on); };
    QObject::connect(action, &QAction::triggered, brush, [=](bool checked) { brush->set(what, checked ? on : off); });
    QObject::connect(brush, &BrushSettings::changed, action, show);
    show();
}
} // namespace

void connectBrush(const Actions& actions, BrushSettings* brush)
{
    const auto action = [&](const char* id) { return actions.get(QLatin1StringView(id)); };
    auto* group = new QActionGroup(brush);
    for (const ToolAction& row : toolActions) {
        group->addAction(action(row.id));
        connectChoice(action(row.id), brush, &core::StrokeSettings::tool, row.tool, row.tool);
        const auto offer = [tool = action(row.id), brush, row] { tool->setEnabled(brush->isOffered(row.tool)); };
        QObject::connect(brush, &BrushSettings::changed, action(row.id), offer);
    }
    connectChoice(action("brush.ray"), brush, &core::StrokeSettings::brush, core::BrushShape::Ray,
                  core::BrushShape::Sphere);
    connectChoice(action("topology.fusion"), brush, &core::StrokeSettings::fusion, true, false);

    QAction* uniform = action("topology.uniform");
    const auto showUniform = [=] { uniform->setChecked(brush->stroke().topology == core::Topology::Uniform); };
    QObject::connect(uniform, &QAction::triggered, brush, &BrushSettings::setUniform);
    QObject::connect(brush, &BrushSettings::changed, uniform, showUniform);
    showUniform();
    QAction* symmetric = action("symmetry.on");
    const auto showSymmetry = [=] { symmetric->setChecked(brush->stroke().symmetry != core::Symmetry::None); };
    QObject::connect(symmetric, &QAction::triggered, brush, &BrushSettings::setSymmetric);
    QObject::connect(brush, &BrushSettings::changed, symmetric, showSymmetry);
    showSymmetry();
    QAction* radial = action("symmetry.radial");
    const auto showRadial = [=] { radial->setChecked(brush->stroke().radial > 1); };
    QObject::connect(radial, &QAction::triggered, brush, &BrushSettings::setRadial);
    QObject::connect(brush, &BrushSettings::changed, radial, showRadial);
    showRadial();

    QObject::connect(action("brush.smaller"), &QAction::triggered, brush,
                     [brush] { brush->scaleRadius(smallerRadius); });
    QObject::connect(action("brush.larger"), &QAction::triggered, brush,
                     [brush] { brush->scaleRadius(1 / smallerRadius); });
}
} // namespace ui
