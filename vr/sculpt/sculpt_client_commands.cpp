// What hands and panels ask for.
#include "vr/sculpt/sculpt_client.h"

#include "vr/util/overloaded.h"

namespace vr
{
namespace
{
template <class... Kinds> bool isOneOf(const Deed& deed)
{
    return (std::holds_alternative<Kinds>(deed) || ...);
}

/// Something chosen, switched or ordered: the hand feels a tick.
bool isStep(const Deed& deed)
{
    return isOneOf<StepTool, SelectChannel, ToggleTopology, ToggleBrushShape, ToggleSymmetry, ToggleInverse>(deed) ||
           isOneOf<OpenToolMenu, OpenColorPanel, Undo, Redo, SaveModel, RestoreModel>(deed);
}

core::Rgb slid(core::Rgb color, const Slide& slide)
{
    constexpr std::array channels{&core::Rgb::r, &core::Rgb::g, &core::Rgb::b};
    if (const auto channel = static_cast<std::size_t>(slide.slider); channel < channels.size())
        color.*channels[channel] = static_cast<std::uint8_t>(slide.value);
    return color;
}
} // namespace

void SculptClient::obey(const std::vector<HandCommand>& commands)
{
    for (const HandCommand& command : commands)
        obey(command);
}

void SculptClient::obey(const HandCommand& command)
{
    const Side side = command.side;
    const auto refuse = [&] { feeling(side).refused = true; };
    const auto act = [&](const std::optional<PanelAction>& action) {
        if (action)
            obey(side, *action);
    };
    const Overloaded obeyed{
        [&](const BeginStroke& begin) { m_brush.begin(begin, m_room) ? void() : refuse(); },
        [&](const StrokePoint& point) { m_brush.draw(point, m_room); },
        [&](const EndStroke&) { m_brush.end(); },
        [&](const Refuse&) { refuse(); },
        [&](const TurnModel& turn) { m_room.turn(turn.angle * m_choice.turnsBy / turnSpeed); },
        [&](const ScaleModel& scale) { m_room.scale(scale.factor); },
        [&](const MoveModel& move) { m_room.move(move.from, move.to); },
        [&](const StretchModel& stretch) { m_room.stretch(stretch.from, stretch.to); },
        [&](const OpenToolMenu& menu) { m_wall.open(PanelKind::Tools, menu.isOpen); },
        [&](const OpenColorPanel& panel) { m_wall.open(PanelKind::Color, panel.isOpen); },
        [&](const PressPanel&) { act(m_wall.press(side)); },
        [&](const ReleasePanel& release) { act(m_wall.release(side, release.isClick)); },
        [&](const Undo& undo) { m_port->wish(undo); },
        [&](const Redo& redo) { m_port->wish(redo); },
        [&](const SaveModel& save) { m_port->wish(save); },
        [&](const RestoreModel& restore) { m_port->wish(restore); },
        [&](const auto& ofBrush) { m_brush.change(changed(m_brush.state(), ofBrush)); },
    };
    feeling(side).stepped = feeling(side).stepped || isStep(command.deed);
    std::visit(obeyed, command.deed);
}

void SculptClient::obey(Side side, const PanelAction& action)
{
    const Overloaded obeyed{
        [&](PanelCommand command) { obey(command); },
        [&](const ShowPanel& panel) { m_wall.open(panel.kind, panel.isShown); },
        [&](SettingsPage page) { m_page = page; },
        [&](const ShowLessonPage& shown) { m_lessonPage = shown.page; },
        [&](LessonWish wish) { m_port->wish(wish); },
        [&](const ChooseChannel& channel) { m_hands.selectChannel(channel.channel); },
        // Of the item that was pressed: what is painted may be older than the changes.
        [&](const OpenFile& file) { m_port->wish(OpenModel{file.path, file.losesChanges}); },
        [](const auto&) {},
    };
    feeling(side).stepped = true;
    std::visit(obeyed, action);
    obeyBrush(action);
    m_files = m_files.after(action);
    choose(SettingsPanel::after(m_choice, action));
}

void SculptClient::obeyBrush(const PanelAction& action)
{
    BrushState brush = m_brush.state();
    core::StrokeSettings& stroke = brush.stroke;
    const Overloaded obeyed{
        [&](core::Tool tool) { stroke.tool = tool; },
        [&](core::BrushShape shape) { stroke.brush = shape; },
        [&](core::Topology topology) { stroke.topology = topology; },
        [&](const ChooseSymmetry& symmetry) { stroke.symmetry = symmetry.isOn ? brush.plane : core::Symmetry::None; },
        [&](const ChooseRadial& chosen) { stroke.radial = chosen.count; },
        [&](const ChooseColor& chosen) { stroke.color = chosen.color; },
        [&](const Slide& slide) { stroke.color = slid(stroke.color, slide); },
        [](const auto&) {},
    };
    std::visit(obeyed, action);
    m_brush.change(brush);
}

void SculptClient::obey(PanelCommand command)
{
    switch (command) {
    case PanelCommand::Undo:
        return m_port->wish(Undo{});
    case PanelCommand::Redo:
        return m_port->wish(Redo{});
    case PanelCommand::RestoreModel:
        return m_port->wish(RestoreModel{});
    case PanelCommand::InvertMask:
        return m_port->wish(core::MaskOperation{core::MaskOperation::Kind::Invert});
    case PanelCommand::ClearMask:
        return m_port->wish(core::MaskOperation{core::MaskOperation::Kind::Clear});
    case PanelCommand::SaveModel:
        return m_port->wish(SaveModel{});
    case PanelCommand::Recentre:
        m_output.recentre = true;
        return;
    case PanelCommand::LeaveVr:
        m_output.leave = true;
        return;
    }
}

void SculptClient::choose(const HeadsetChoice& choice)
{
    if (choice == m_choice)
        return;
    const HeadsetChoice before = std::exchange(m_choice, choice);
    if (choice.hands != before.hands)
        obey(m_hands.choose(choice.hands));
    if (choice.raised != before.raised)
        m_room.move({}, {Eigen::Quaterniond::Identity(), core::Vec3(0, choice.raised - before.raised, 0)});
    m_haptics.setLevels(choice.feel);
    m_port->wish(choice);
}
} // namespace vr
