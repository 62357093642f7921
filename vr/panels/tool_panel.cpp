#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"

#include <cmath>

namespace vr
{
namespace
{
constexpr double toolWidth = 1260, toolNameWidth = 210, toolHeight = 124, buttonHeight = 84, groupGap = 8,
                 toolTitleWidth = 300;
constexpr double brushWidth = 450, radiusWidth = 135, radiusStep = 0.25;
constexpr double symmetryWidth = 270, radialWidth = 170;
constexpr double filesButtonWidth = 225, partsButtonWidth = 215, levelButtonWidth = 265, addButtonWidth = 230,
                 leaveButtonWidth = 245;
constexpr double toolDistance = 0.5; ///< metres from which the panel is read: it is held up by a hand
constexpr std::array<std::size_t, 4> toolsInRow{4, 4, 4, 4};

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
    case core::Tool::Inflate:
        return tr("Inflate");
    case core::Tool::Clay:
        return tr("Clay");
    case core::Tool::Layer:
        return tr("Layer");
    case core::Tool::Flatten:
        return tr("Flatten");
    case core::Tool::Scrape:
        return tr("Scrape");
    case core::Tool::Smooth:
        return tr("Smooth");
    case core::Tool::Pinch:
        return tr("Pinch");
    case core::Tool::Crease:
        return tr("Crease");
    case core::Tool::Grab:
        return tr("Grab");
    case core::Tool::SnakeHook:
        return tr("Snake Hook");
    case core::Tool::Twist:
        return tr("Twist");
    case core::Tool::Stamp:
        return tr("Stamp");
    case core::Tool::Paint:
        return tr("Paint");
    case core::Tool::Mask:
        return tr("Mask");
    }
    return {};
}

void ToolPanel::addTools(PanelBuilder& builder) const
{
    int next = 0;
    for (const std::size_t count : toolsInRow)
        for (const QRectF& place : evenCells(builder.nextRow(toolHeight), count)) {
            const auto shown = static_cast<core::Tool>(next++);
            builder.add(
                place,
                {{.text = nameOf(shown), .icon = iconOf(shown), .isChosen = shown == tool, .isUpright = true}, shown});
        }
}

/// Adds the brush's shape and a slider for its radius, each of whose steps multiplies it by the same factor.
void ToolPanel::addBrush(PanelBuilder& builder) const
{
    const std::vector<QRectF> places = cells(builder.nextRow(theme::row), {toolNameWidth, brushWidth, 0, radiusWidth});
    builder.add(places[0], TextLook{.text = tr("Brush"), .lines = 2});
    builder.addChoice(
        places[1],
        {{tr("Sphere"), QStringLiteral("sphere"), core::BrushShape::Sphere, brush == core::BrushShape::Sphere},
         {tr("Ray"), QStringLiteral("ray"), core::BrushShape::Ray, brush == core::BrushShape::Ray}});
    const double doublings = std::ceil(std::log2(maxRadius / minRadius) / radiusStep) * radiusStep;
    builder.add({places[2], SliderLook{.max = doublings, .step = radiusStep},
                 Slide{PanelSlider::Radius, std::log2(radius / minRadius)}});
    //: %1: a radius in the room
    builder.add(places[3], TextLook{.text = tr("%1 mm").arg(std::lround(radius * 1000)),
                                    .role = TextRole::Number,
                                    .alignment = Qt::AlignRight | Qt::AlignVCenter});
}

/// Adds the buttons that open other panels, and those that concern the whole scene.
void ToolPanel::addPanelButtons(PanelBuilder& builder) const
{
    const std::vector<QRectF> upper = cells(builder.nextRow(buttonHeight), {filesButtonWidth, partsButtonWidth, 0, 0});
    builder.add(upper[0], {{.text = tr("Files"), .icon = QStringLiteral("files")}, ShowPanel{PanelKind::Files}});
    builder.add(upper[1], {{.text = tr("Parts"), .icon = QStringLiteral("part-union")}, ShowPanel{PanelKind::Parts}});
    builder.add(upper[2],
                {{.text = tr("Settings"), .icon = QStringLiteral("preferences")}, ShowPanel{PanelKind::Settings}});
    builder.add(upper[3], {{.text = tr("Recentre"), .icon = QStringLiteral("recentre")}, PanelCommand::Recentre});
    const std::vector<QRectF> lower =
        cells(builder.nextRow(buttonHeight), {levelButtonWidth, addButtonWidth, 0, leaveButtonWidth});
    builder.add(lower[0], {{.text = tr("Level"), .icon = QStringLiteral("level")}, PanelCommand::LevelModel});
    builder.add(lower[1],
                {{.text = tr("Add ball"), .icon = QStringLiteral("add"), .isChosen = addsNext}, AddNext{!addsNext}});
    builder.add(lower[2], {{.text = tr("Hold to restore"), .icon = QStringLiteral("reset")},
                           PanelCommand::RestoreModel,
                           canChange,
                           true});
    builder.add(lower[3], {{.text = tr("Leave VR"), .icon = QStringLiteral("quit")}, PanelCommand::LeaveVr});
}

void ToolPanel::addSymmetry(PanelBuilder& builder) const
{
    const std::vector<QRectF> places =
        cells(builder.nextRow(theme::row), {toolNameWidth, symmetryWidth, radialWidth, 0});
    builder.add(places[0], TextLook{.text = tr("Symmetry"), .lines = 2});
    builder.add({places[1], SwitchLook{isSymmetric ? tr("On") : tr("Off"), isSymmetric}, ChooseSymmetry{!isSymmetric}});
    builder.add(places[2], TextLook{.text = tr("Radial"), .lines = 2});
    std::vector<PanelChoice> sectors;
    for (const int count : {1, 2, 4, 6})
        sectors.push_back({QString::number(count), {}, ChooseRadial{count}, count == radial});
    builder.addChoice(places[3], sectors);
}

void ToolPanel::addMask(PanelBuilder& builder) const
{
    const std::vector<QRectF> places = cells(builder.nextRow(theme::row), {toolNameWidth, 0, 0});
    builder.add(places[0], TextLook{.text = tr("Mask"), .lines = 2});
    builder.add(places[1],
                {{.text = tr("Invert"), .icon = QStringLiteral("mask-invert")}, PanelCommand::InvertMask, canChange});
    builder.add(places[2],
                {{.text = tr("Clear"), .icon = QStringLiteral("mask-clear")}, PanelCommand::ClearMask, canChange});
}

PanelLayout ToolPanel::layout() const
{
    using core::Topology;
    PanelBuilder builder(PanelKind::Tools, toolWidth, toolDistance);
    const auto choice = [this](const QString& text, Topology value) {
        return PanelChoice{text, QLatin1StringView(name(value)), value, topology == value};
    };
    builder.addTitle({tr("Tools"), isInverse ? tr("Inverted") : QString(), toolTitleWidth},
                     {{{.icon = QStringLiteral("undo")}, PanelCommand::Undo, canUndo},
                      {{.icon = QStringLiteral("redo")}, PanelCommand::Redo, canRedo}});
    addTools(builder);
    builder.skip(groupGap);
    addBrush(builder);
    builder.addChoice(tr("Topology"), toolNameWidth,
                      {choice(tr("Refine"), Topology::Refine), choice(tr("Adaptive"), Topology::Adaptive)});
    builder.addChoice(cells(builder.nextRow(theme::row), {toolNameWidth, 0}).back(),
                      {choice(tr("Keep"), Topology::Keep), choice(tr("Uniform"), Topology::Uniform)});
    addSymmetry(builder);
    addMask(builder);
    builder.skip(groupGap);
    addPanelButtons(builder);
    return builder.finished();
}
} // namespace vr
