// What hands and panels ask for.
#include "sculpt_client.h"

#include "overloaded.h"

namespace vr
{
namespace
{
/// A thing chosen or switched: the hand feels a tick.
bool isStep(const Deed& deed)
{
    constexpr Overloaded steps{[](const StepTool&) { return true; },       [](const SelectChannel&) { return true; },
                               [](const ToggleTopology&) { return true; }, [](const ToggleBrushShape&) { return true; },
                               [](const ToggleSymmetry&) { return true; }, [](const ToggleInverse&) { return true; },
                               [](const OpenToolMenu&) { return true; },   [](const OpenColorPanel&) { return true; },
                               [](const Undo&) { return true; },           [](const Redo&) { return true; },
                               [](const SaveModel&) { return true; },      [](const RestoreModel&) { return true; },
                               [](const auto&) { return false; }};
    return std::visit(steps, deed);
}
} // namespace

void SculptClient::obey(const std::vector<HandCommand>& commands)
{
    for (const HandCommand& command : commands)
        obey(command);
}

void SculptClient::obey(const HandCommand& command)
{
    feeling(command.side).stepped = feeling(command.side).stepped || isStep(command.deed);
    if (obeyStroke(command) || obeyView(command.deed) || obeyDocument(command))
        return;
    m_brush.change(changed(m_brush.state(), command.deed));
}

bool SculptClient::obeyStroke(const HandCommand& command)
{
    const auto refuse = [&] { feeling(command.side).refused = true; };
    const Overloaded stroke{[&](const BeginStroke& begin) {
                                if (!m_brush.begin(begin, m_room))
                                    refuse();
                                return true;
                            },
                            [&](const StrokePoint& point) {
                                m_brush.draw(point, m_room);
                                return true;
                            },
                            [&](const EndStroke&) {
                                m_brush.end();
                                return true;
                            },
                            [&](const Refuse&) {
                                refuse();
                                return true;
                            },
                            [](const auto&) { return false; }};
    return std::visit(stroke, command.deed);
}

bool SculptClient::obeyView(const Deed& deed)
{
    const Overloaded view{[&](const TurnModel& turn) {
                              m_room.turn(turn.angle * m_choice.turnsBy / turnSpeed);
                              return true;
                          },
                          [&](const ScaleModel& scale) {
                              m_room.scale(scale.factor);
                              return true;
                          },
                          [&](const MoveModel& move) {
                              m_room.move(move.from, move.to);
                              return true;
                          },
                          [&](const StretchModel& stretch) {
                              m_room.stretch(stretch.from, stretch.to);
                              return true;
                          },
                          [&](const OpenToolMenu& menu) {
                              m_wall.open(PanelKind::Tools, menu.isOpen);
                              return true;
                          },
                          [&](const OpenColorPanel& panel) {
                              m_wall.open(PanelKind::Color, panel.isOpen);
                              return true;
                          },
                          [](const auto&) { return false; }};
    return std::visit(view, deed);
}

bool SculptClient::obeyDocument(const HandCommand& command)
{
    const auto wish = [&](const auto& what) {
        m_port->wish(what);
        return true;
    };
    const auto act = [&](const std::optional<PanelAction>& action) {
        if (action)
            obey(command.side, *action);
        return true;
    };
    const Overloaded document{
        [&](const Undo& undo) { return wish(undo); },
        [&](const Redo& redo) { return wish(redo); },
        [&](const SaveModel& save) { return wish(save); },
        [&](const RestoreModel& restore) { return wish(restore); },
        [&](const PressPanel&) { return act(m_wall.press(command.side)); },
        [&](const ReleasePanel& release) { return act(m_wall.release(command.side, release.isClick)); },
        [](const auto&) { return false; }};
    return std::visit(document, command.deed);
}

void SculptClient::obey(Side side, const PanelAction& action)
{
    feeling(side).stepped = true;
    if (obeyBrush(action))
        return;
    if (const auto* command = std::get_if<PanelCommand>(&action))
        return obey(*command);
    if (const auto* panel = std::get_if<ShowPanel>(&action))
        return m_wall.open(panel->kind, panel->isShown);
    if (const auto* page = std::get_if<SettingsPage>(&action))
        m_page = *page;
    else if (const auto* channel = std::get_if<ChooseChannel>(&action))
        m_hands.selectChannel(channel->channel);
    else if (const auto* file = std::get_if<OpenFile>(&action))
        m_port->wish(OpenModel{file->path, m_files.hasUnsavedChanges}); // then the button was held
    m_files = m_files.after(action);
    choose(SettingsPanel::after(m_choice, action));
}

/// Whether it was one of the brush.
bool SculptClient::obeyBrush(const PanelAction& action)
{
    BrushState brush = m_brush.state();
    const auto color = [&](const Slide& slide) {
        constexpr std::array channels{&core::Rgb::r, &core::Rgb::g, &core::Rgb::b};
        const auto channel = static_cast<std::size_t>(slide.slider);
        if (channel >= channels.size())
            return false;
        brush.stroke.color.*channels[channel] = static_cast<std::uint8_t>(slide.value);
        return true;
    };
    const Overloaded change{[&](core::Tool tool) { return brush.stroke.tool = tool, true; },
                            [&](core::BrushShape shape) { return brush.stroke.brush = shape, true; },
                            [&](core::Topology topology) { return brush.stroke.topology = topology, true; },
                            [&](const ChooseSymmetry& symmetry) {
                                return brush.stroke.symmetry = symmetry.isOn ? brush.plane : core::Symmetry::None, true;
                            },
                            [&](const ChooseColor& chosen) { return brush.stroke.color = chosen.color, true; },
                            [&](const Slide& slide) { return color(slide); },
                            [](const auto&) { return false; }};
    const bool isOfBrush = std::visit(change, action);
    m_brush.change(brush);
    return isOfBrush;
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
