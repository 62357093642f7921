// What hands and panels ask for.
#include "vr/sculpt/sculpt_client.h"

#include "vr/util/overloaded.h"

namespace vr
{
namespace
{
template <class... Kinds> bool isOneOf(const WandAction& action)
{
    return (std::holds_alternative<Kinds>(action) || ...);
}

/// Something chosen, switched or ordered: the hand feels a tick.
bool isStep(const WandAction& action)
{
    return isOneOf<StepTool, SelectChannel, ToggleTopology, ToggleBrushShape, ToggleSymmetry, ToggleInverse>(action) ||
           isOneOf<OpenToolMenu, OpenColorPanel, Undo, Redo, SaveModel, RestoreModel>(action);
}

core::Rgb slid(core::Rgb color, const Slide& slide)
{
    constexpr std::array channels{&core::Rgb::r, &core::Rgb::g, &core::Rgb::b};
    if (const auto channel = static_cast<std::size_t>(slide.slider); channel < channels.size())
        color.*channels[channel] = static_cast<std::uint8_t>(slide.value);
    return color;
}
} // namespace

void SculptClient::handle(const std::vector<WandCommand>& commands)
{
    for (const WandCommand& command : commands)
        handle(command);
}

void SculptClient::handle(const WandCommand& command)
{
    const Side side = command.side;
    const auto refuse = [&] { hapticInput(side).refused = true; };
    const auto act = [&](const std::optional<PanelAction>& action) {
        if (action)
            handle(side, *action);
    };
    const Overloaded handler{
        [&](const BeginStroke& begin) { m_brush.begin(begin, m_placement) ? void() : refuse(); },
        [&](const StrokePoint& point) { m_brush.draw(point, m_placement); },
        [&](const EndStroke&) { m_brush.end(); },
        [&](const Refuse&) { refuse(); },
        [&](const TurnModel& turn) { m_placement.turn(turn.angle * m_settings.turnRate / turnSpeed); },
        [&](const ScaleModel& scale) { m_placement.scale(scale.factor); },
        [&](const MoveModel& move) { m_placement.move(move.from, move.to); },
        [&](const StretchModel& stretch) { m_placement.stretch(stretch.from, stretch.to); },
        [&](const OpenToolMenu& menu) { m_panels.open(PanelKind::Tools, menu.isOpen); },
        [&](const OpenColorPanel& panel) { m_panels.open(PanelKind::Color, panel.isOpen); },
        [&](const PressPanel&) { act(m_panels.press(side)); },
        [&](const ReleasePanel& release) { act(m_panels.release(side, release.isClick)); },
        [&](const Undo& undo) { m_port->request(undo); },
        [&](const Redo& redo) { m_port->request(redo); },
        [&](const SaveModel& save) { m_port->request(save); },
        [&](const RestoreModel& restore) { m_port->request(restore); },
        [&](const auto& ofBrush) { m_brush.change(changed(m_brush.state(), ofBrush)); },
    };
    hapticInput(side).stepped = hapticInput(side).stepped || isStep(command.action);
    std::visit(handler, command.action);
}

void SculptClient::handle(Side side, const PanelAction& action)
{
    const Overloaded handler{
        [&](PanelCommand command) { handle(command); },
        [&](const ShowPanel& panel) { m_panels.open(panel.kind, panel.isShown); },
        [&](SettingsPage page) { m_page = page; },
        [&](const ShowLessonPage& shown) { m_lessonPage = shown.page; },
        [&](LessonRequest request) { m_port->request(request); },
        [&](const ChooseChannel& channel) { m_mapping.selectChannel(channel.channel); },
        // Of the item that was pressed: what is painted may be older than the changes.
        [&](const OpenFile& file) {
            m_port->request(OpenModel{file.path, file.discardsChanges});
        },
        [](const auto&) {},
    };
    hapticInput(side).stepped = true;
    std::visit(handler, action);
    handleBrush(action);
    m_files = m_files.after(action);
    applySettings(SettingsPanel::after(m_settings, action));
}

void SculptClient::handleBrush(const PanelAction& action)
{
    BrushState brush = m_brush.state();
    core::StrokeSettings& stroke = brush.stroke;
    const Overloaded handler{
        [&](core::Tool tool) { stroke.tool = tool; },
        [&](core::BrushShape shape) { stroke.brush = shape; },
        [&](core::Topology topology) { stroke.topology = topology; },
        [&](const ChooseSymmetry& symmetry) { stroke.symmetry = symmetry.isOn ? brush.plane : core::Symmetry::None; },
        [&](const ChooseRadial& chosen) { stroke.radial = chosen.count; },
        [&](const ChooseColor& chosen) { stroke.color = chosen.color; },
        [&](const Slide& slide) { stroke.color = slid(stroke.color, slide); },
        [](const auto&) {},
    };
    std::visit(handler, action);
    m_brush.change(brush);
}

void SculptClient::handle(PanelCommand command)
{
    switch (command) {
    case PanelCommand::Undo:
        return m_port->request(Undo{});
    case PanelCommand::Redo:
        return m_port->request(Redo{});
    case PanelCommand::RestoreModel:
        return m_port->request(RestoreModel{});
    case PanelCommand::InvertMask:
        return m_port->request(core::MaskOperation{core::MaskOperation::Kind::Invert});
    case PanelCommand::ClearMask:
        return m_port->request(core::MaskOperation{core::MaskOperation::Kind::Clear});
    case PanelCommand::SaveModel:
        return m_port->request(SaveModel{});
    case PanelCommand::Recentre:
        m_output.recentre = true;
        return;
    case PanelCommand::LeaveVr:
        m_output.leave = true;
        return;
    }
}

void SculptClient::applySettings(const HeadsetSettings& settings)
{
    if (settings == m_settings)
        return;
    const HeadsetSettings before = std::exchange(m_settings, settings);
    if (settings.wands != before.wands)
        handle(m_mapping.setSettings(settings.wands));
    if (settings.heightOffset != before.heightOffset)
        m_placement.move(
            {}, {Eigen::Quaterniond::Identity(), core::Vec3(0, settings.heightOffset - before.heightOffset, 0)});
    m_haptics.setLevels(settings.hapticLevels);
    m_port->request(settings);
}
} // namespace vr
