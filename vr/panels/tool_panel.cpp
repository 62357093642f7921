#include "panel_builder.h"
#include "panel_content.h"
#include "panel_theme.h"

namespace vr
{
namespace
{
constexpr double toolWidth = 980, toolNameWidth = 210, toolHeight = 140, buttonHeight = 84, groupGap = 8, toolTitleWidth = 300;
constexpr double filesWidth = 220, recentreWidth = 266;
constexpr double toolDistance = 0.5; ///< metres; a hand that holds something up to be read
constexpr std::array tools{core::Tool::Pull, core::Tool::Push, core::Tool::Flatten, core::Tool::Smooth,
                           core::Tool::Paint};

QString iconOf(core::Tool tool)
{
    const std::string_view name = core::name(tool);
    return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}
} // namespace

QString ToolPanel::nameOf(core::Tool tool)
{
    switch (tool) {
    case core::Tool::Pull:
        return tr("Pull");
    case core::Tool::Push:
        return tr("Push");
    case core::Tool::Flatten:
        return tr("Flatten");
    case core::Tool::Smooth:
        return tr("Smooth");
    case core::Tool::Paint:
        return tr("Paint");
    }
    return {};
}

/// Where this panel leads to, and what else concerns all that is seen.
void ToolPanel::addDoors(PanelBuilder& builder) const
{
    const std::vector<QRectF> upper = cells(builder.nextRow(buttonHeight), {filesWidth, 0, recentreWidth});
    builder.add(upper[0], {{.text = tr("Files"), .icon = QStringLiteral("files"), .isChosen = showsFiles},
                           ShowPanel{PanelKind::Files, !showsFiles}});
    builder.add(upper[1], {{.text = tr("Settings"), .icon = QStringLiteral("preferences"), .isChosen = showsSettings},
                           ShowPanel{PanelKind::Settings, !showsSettings}});
    builder.add(upper[2], {{.text = tr("Recentre"), .icon = QStringLiteral("recentre")}, PanelCommand::Recentre});
    const std::vector<QRectF> lower = evenCells(builder.nextRow(buttonHeight), 2);
    builder.add(lower[0], {{.text = tr("Hold to restore"), .icon = QStringLiteral("reset")},
                           PanelCommand::RestoreModel,
                           canRestore,
                           true});
    builder.add(lower[1], {{.text = tr("Leave VR"), .icon = QStringLiteral("quit")}, PanelCommand::LeaveVr});
}

PanelLayout ToolPanel::layout() const
{
    using core::BrushShape, core::Topology;
    PanelBuilder builder(PanelKind::Tools, toolWidth, toolDistance);
    builder.addTitle({tr("Tools"), isInverse ? tr("Pull and Push swapped") : QString(), toolTitleWidth},
                     {{{.icon = QStringLiteral("undo")}, PanelCommand::Undo, canUndo},
                      {{.icon = QStringLiteral("redo")}, PanelCommand::Redo, canRedo}});
    const std::vector<QRectF> places = evenCells(builder.nextRow(toolHeight), tools.size());
    for (std::size_t i = 0; i < tools.size(); ++i)
        builder.add(
            places[i],
            {{.text = nameOf(tools[i]), .icon = iconOf(tools[i]), .isChosen = tools[i] == tool, .isUpright = true},
             tools[i]});
    builder.skip(groupGap);
    builder.addChoice(tr("Brush"), toolNameWidth,
                      {{tr("Sphere"), QStringLiteral("sphere"), BrushShape::Sphere, brush == BrushShape::Sphere},
                       {tr("Ray"), QStringLiteral("ray"), BrushShape::Ray, brush == BrushShape::Ray}});
    builder.addChoice(tr("Topology"), toolNameWidth,
                      {{tr("Adaptive"), QStringLiteral("adaptive"), Topology::Adaptive, topology == Topology::Adaptive},
                       {tr("Uniform"), QStringLiteral("uniform"), Topology::Uniform, topology == Topology::Uniform}});
    builder.addSwitch(tr("Symmetry"), toolNameWidth, {isSymmetric ? tr("On") : tr("Off"), isSymmetric},
                      ChooseSymmetry{!isSymmetric});
    builder.skip(groupGap);
    addDoors(builder);
    return builder.finished();
}
} // namespace vr
