#include "vr/sculpt/sculpt_client.h"

#include "vr/sculpt/part_requests.h"
#include "vr/sculpt/shape_tool.h"

#include "core/util/overloaded.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <cmath>

namespace vr
{
namespace
{
constexpr double stillPhase = 0.4;
constexpr double bladeRadius = 0.25; ///< metres: a blade shows around a model that was placed in front of the user
/// Period of the pulsing light at a pointed place, seconds: it is noticed, but does not flicker.
constexpr double pulseSeconds = 1.2;

/// Returns a ball around the model, in room space. Panels are placed outside it and where it does not hide them.
core::Sphere modelSphere(const ModelPlacement& placement, const core::Box& box)
{
    return {placement.middle(), box.isEmpty() ? 0 : placement.lengthToRoom(box.sizes().maxCoeff()) / 2};
}

template <class... Kinds> bool isOneOf(const WandAction& action)
{
    return (std::holds_alternative<Kinds>(action) || ...);
}

/// Returns whether the action chooses, switches or orders something, which the hand feels as a tick.
bool isStep(const WandAction& action)
{
    return isOneOf<StepTool, SelectChannel, ToggleTopology, ToggleBrushShape, ToggleSymmetry, ToggleInverse>(action) ||
           isOneOf<OpenToolMenu, OpenColorPanel, Undo, Redo, SaveModel, RestoreModel, UseTip>(action);
}

/// Returns the request to the document for a panel's command; none if the command concerns only the headset.
std::optional<DocumentRequest> requestOf(PanelCommand command)
{
    switch (command) {
    case PanelCommand::Undo:
        return Undo{};
    case PanelCommand::Redo:
        return Redo{};
    case PanelCommand::RestoreModel:
        return RestoreModel{};
    case PanelCommand::InvertMask:
        return core::MaskOperation{core::MaskOperation::Kind::Invert};
    case PanelCommand::ClearMask:
        return core::MaskOperation{core::MaskOperation::Kind::Clear};
    case PanelCommand::SaveModel:
        return SaveModel{};
    default:
        return std::nullopt;
    }
}

WandPart partOf(Sector sector)
{
    switch (sector) {
    case Sector::Left:
        return WandPart::PadLeft;
    case Sector::Right:
        return WandPart::PadRight;
    case Sector::Top:
        return WandPart::PadUp;
    case Sector::Bottom:
        return WandPart::PadDown;
    }
    return WandPart::PadMiddle;
}

/// Returns whether the trigger and the side button are released.
bool isHandFree(const WandMapping& mapping, Side side)
{
    const WandGestures& gestures = mapping.gestures(side);
    return !gestures.trigger.isDown && !gestures.side.isDown;
}

/// Returns the input with bare hands as wands. `lastHead`: last known pose of the head.
FrameInput withBareHands(const FrameInput& received, std::array<BareHandReader, sideCount>& readers,
                         const Pose& lastHead)
{
    FrameInput input = received;
    for (std::size_t i = 0; i < sideCount; ++i) {
        const WandState wand = readers[i].read(received.wands[i], received.head.value_or(lastHead), received.seconds());
        if (received.hasFocus) // otherwise no hand holds anything, not even for a moment
            input.wands[i] = wand;
    }
    return input;
}

/// Returns the appearance of a wand, except the colour of its tip.
ShownWand shownWand(const WandState& wand, const WandMapping& mapping, Side side)
{
    ShownWand shown;
    shown.isShown = wand.isTracked;
    shown.grip = wand.grip;
    if (wand.isHand)
        shown.pinch = wand.pinch.position;
    const auto light = [&](WandPart part, bool isLit) { shown.isLit[static_cast<std::size_t>(part)] = isLit; };
    const WandGestures& gestures = mapping.gestures(side);
    if (gestures.pad.held)
        light(wand.isStick ? WandPart::Stick : partOf(*gestures.pad.held), true);
    light(WandPart::Trigger, gestures.trigger.isDown);
    light(WandPart::Menu, wand.menu);
    light(WandPart::Side, wand.side);
    shown.trigger = wand.trigger;
    using enum ShownWand::Thumb;
    shown.thumb = wand.isSimple || wand.isHand ? None : wand.isStick ? Stick : Pad;
    if (wand.isStick)
        shown.stick = wand.pad;
    else if (wand.padTouched)
        shown.touch = wand.pad;
    if (const std::optional<WandMapping::Hold> hold = mapping.hold(side))
        shown.holdProgress = hold->progress;
    return shown;
}

/// Returns the appearance of what the sculpting hand holds: the brush, or a ray that points at parts.
std::variant<std::monostate, BallBrush, RayBrush>
shownAtTip(const WandBrush& brush, HandTask task, const std::optional<Pose>& tip, const ModelPlacement& placement)
{
    if (task == HandTask::Sculpt)
        return brush.shown(placement);
    if (!tip || task != HandTask::ChoosePart)
        return {};
    return RayBrush{{tip->position, tip->forward()}, {}};
}

/// Returns the shape whose outline is at the tip before the trigger is pulled; where a tube would begin a ball as
/// thick.
std::optional<core::Primitive::Kind> outlinedAtTip(HandTask task, core::Primitive::Kind chosen)
{
    if (task == HandTask::DrawTube)
        return core::Primitive::Kind::Ball;
    return task == HandTask::PlaceShape ? std::optional(chosen) : std::nullopt;
}

/// Returns what the window shows of the user. `radius`: radius of the brush, metres.
AvatarState avatarOf(const FrameInput& input, const SceneState& scene, double radius, std::vector<PanelTarget> panels)
{
    AvatarState avatar;
    avatar.panels = std::move(panels);
    avatar.head = input.head;
    for (std::size_t i = 0; i < sideCount; ++i)
        if (input.wands[i].isTracked)
            avatar.hands[i] = input.wands[i].grip;
    if (const auto* ball = std::get_if<BallBrush>(&scene.brush))
        avatar.brush = core::Sphere{ball->center, ball->radius};
    avatar.radius = radius;
    avatar.model = scene.model;
    return avatar;
}
} // namespace

SculptClient::SculptClient(std::shared_ptr<DocumentPort> port, const HeadsetSettings& settings)
    : m_port(std::move(port))
    , m_settings(settings)
    , m_mapping(settings.wands)
    , m_brush(m_port.get(), settings.wands.preset)
    , m_partHand(m_port.get())
    , m_haptics(settings.hapticLevels)
{}

SculptClient::~SculptClient() = default;

bool SculptClient::create(QOpenGLContext& context)
{
    QOpenGLExtraFunctions* gl = context.extraFunctions();
    m_target.create(gl);
    m_panels.create(gl);
    return m_scene.create(gl);
}

void SculptClient::destroy()
{
    handle(m_mapping.releaseAll());
    m_scene.destroy();
    m_panels.destroy();
    m_target.destroy();
}

/// Processes a frame. The order matters: panels are placed before wands are aimed at them, and wands are aimed before
/// their gestures become commands. The surface is queried after the commands, which may change the brush and the
/// placement.
FrameOutput SculptClient::frame(const FrameInput& received)
{
    const FrameInput input = withBareHands(received, m_bareHands, m_head);
    m_output = {};
    m_hapticInputs = {};
    takeUpdate();
    m_partHand.step();
    if (std::optional<core::MeshPatch> patch = m_port->takePatch())
        m_scene.apply(*std::move(patch));
    handleRoomChange(input);
    place(input);
    aimAtPanels(input);
    m_mapping.setTask(m_panels.isOpen(PanelKind::Parts) ? m_contents.parts().task() : HandTask::Sculpt);
    const InputFrame frame{input.seconds(), input.wands, {pointsAtPanel(Side::Left), pointsAtPanel(Side::Right)}};
    const std::vector<WandCommand> commands = m_mapping.step(frame);
    handle(commands);
    m_brush.querySurface(m_placement);
    updateHaptics();
    m_labels.step(frame, m_head, m_mapping, commands);
    m_contents.show(m_panels, {m_update, m_settings, m_brush.state(), m_mapping.channel(), input.timings,
                               input.seconds(), input.offersPassthrough});
    updateScene(input);
    m_port->show(avatarOf(input, m_state, m_brush.state().radius, m_panels.targets()));
    m_output.pulses = m_haptics.step(input.seconds(), m_hapticInputs);
    m_output.passthrough = m_settings.hasPassthrough;
    return m_output;
}

/// Takes over changes of the document. Another model is placed in front of the user; a model that has only grown
/// remains in its place. The sculpting hand feels a tick if the window has changed the brush.
void SculptClient::takeUpdate()
{
    std::optional<DocumentUpdate> update = m_port->takeUpdate();
    if (!update)
        return;
    const bool isAnother = update->model != m_update.model;
    const bool isFirst = m_update.brushChange == 0;
    const bool isPreviewNew = update->preview && !m_update.preview;
    const bool isChosen = update->brushChange != m_update.brushChange || update->radiusChange != m_update.radiusChange;
    hapticInput(m_settings.wands.sculpting).stepped = isChosen && !isFirst;
    m_contents.update(m_update, *update);
    m_update = *std::move(update);
    m_placement.setModel(m_update.box);
    m_brush.take(m_update, m_placement);
    m_isPlaced = m_isPlaced && !isAnother;
    if (isAnother || isPreviewNew)
        m_partHand.drop();
    if (isPreviewNew)
        handle(m_settings.wands.sculpting, ShowPanel{PanelKind::Parts}); // where it can be ended
}

void SculptClient::handleRoomChange(const FrameInput& input)
{
    if (input.head)
        m_head = *input.head;
    if (!input.roomMoved)
        return;
    handle(m_mapping.releaseAll());
    m_panels.resetPlacement();
    m_isPlaced = false;
}

/// Places the model if necessary, and the panels. A new model is placed only when it is loaded completely, because the
/// old one is shown until then.
void SculptClient::place(const FrameInput& input)
{
    if (!m_isPlaced && input.head && !m_scene.isLoading()) {
        m_placement.place(m_head, m_settings.heightOffset);
        m_isPlaced = true;
    }
    PanelManager::Sight sight{m_head,
                              {},
                              m_settings.wands.sculpting,
                              modelSphere(m_placement, m_update.box),
                              m_settings.wands.preset == ButtonPreset::OneHand};
    for (std::size_t i = 0; i < sideCount; ++i)
        if (input.wands[i].isTracked)
            sight.grips[i] = input.wands[i].grip;
    m_panels.place(sight);
}

void SculptClient::aimAtPanels(const FrameInput& input)
{
    const WandState& sculpting = input.wands[static_cast<std::size_t>(m_settings.wands.sculpting)];
    m_tip = sculpting.isTracked ? std::optional(tipOf(sculpting)) : std::nullopt;
    m_brush.aim(m_tip);
    for (const Side side : {Side::Left, Side::Right}) {
        const WandState& wand = input.wands[static_cast<std::size_t>(side)];
        std::optional<PanelPointer::Aim> aim;
        if (wand.isTracked && wand.isHand)
            aim = {{wand.aim.position, wand.aim.forward()}, 0, false};
        else if (wand.isTracked)
            aim = {{wand.grip.position, wand.aim.forward()}, tipReach, isHandFree(m_mapping, side)};
        if (const std::optional<PanelAction> action = m_panels.aim(side, aim, input.seconds()))
            handle(side, *action);
        if (!pointsAtPanel(side))
            m_panels.lookAway(side);
    }
}

/// Returns whether the wand points at a panel, so that its trigger acts there. A tip that has gone through a panel
/// still points at it. A brush that touches the model sculpts instead, and so does a ray that meets the model before
/// the panel.
bool SculptClient::pointsAtPanel(Side side) const
{
    const std::optional<PanelPointer::Spot>& spot = m_panels.spot(side);
    if (!spot || m_mapping.isDrawing(side))
        return false;
    if (side != m_settings.wands.sculpting || !m_tip)
        return true;
    const double ahead = (spot->point - m_tip->position).dot(m_tip->forward());
    if (ahead < 0)
        return true;
    const std::optional<double> reach = m_brush.reach(m_placement);
    return !m_brush.touches(m_placement) && !(reach && *reach < ahead);
}

void SculptClient::updateHaptics()
{
    const Side side = m_settings.wands.sculpting;
    const StrokeEffect effect = m_port->takeEffect();
    hapticInput(side).touches = m_brush.touches(m_placement);
    hapticInput(side).pressure = m_brush.touches(m_placement) ? m_brush.pressure() : 0;
    hapticInput(side).fused = hapticInput(side).fused || effect.fusions > 0;
    hapticInput(side).refused = hapticInput(side).refused || effect.refusals > 0;
    for (const Side each : {Side::Left, Side::Right})
        if (const std::optional<WandMapping::Hold> hold = m_mapping.hold(each))
            hapticInput(each).hold = hold->progress;
}

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
    const core::Overloaded handler{
        [&](const BeginStroke& begin) {
            if (m_mapping.task() == HandTask::DrawTube && !m_update.preview)
                m_tube.begin();
            else if (!m_brush.begin(begin, m_placement))
                refuse();
        },
        [&](const StrokePoint& point) {
            if (m_tube.isDrawing())
                m_tube.add(tubePointAt(point.tip, m_brush.state(), m_placement));
            else
                m_brush.draw(point, m_placement);
        },
        [&](const EndStroke&) {
            if (!m_tube.isDrawing())
                return m_brush.end();
            if (const std::optional<core::Primitive> tube = m_tube.end(m_placement))
                m_port->request(tubeRequest(*tube, m_contents.parts(), m_brush.state()));
            else
                refuse();
        },
        [&](const Refuse&) { refuse(); },
        [&](const TurnModel& turn) { m_placement.turn(turn.angle * m_settings.turnRate / turnSpeed); },
        [&](const ScaleModel& scale) { m_placement.scale(scale.factor); },
        [&](const MoveModel& move) { m_placement.move(move.from, move.to); },
        [&](const StretchModel& stretch) { m_placement.stretch(stretch.from, stretch.to); },
        [&](const OpenToolMenu& menu) { m_panels.open(PanelKind::Tools, menu.isOpen); },
        [&](const OpenColorPanel& panel) { m_panels.open(PanelKind::Color, panel.isOpen); },
        [&](const UseTip& use) {
            if (m_update.preview)
                return refuse();
            m_port->request(
                requestAt({use.tip, m_mapping.task(), m_update.box}, m_contents.parts(), m_brush.state(), m_placement));
        },
        [&](const MovePart& move) {
            if (!m_update.preview)
                m_partHand.move(move, m_update.activePart, m_placement);
        },
        [&](const ReleasePart&) { m_partHand.release(); },
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
    const core::Overloaded handler{
        [&](PanelCommand command) {
            if (const std::optional<DocumentRequest> request = requestOf(command))
                m_port->request(*request);
            m_output.recentre = m_output.recentre || command == PanelCommand::Recentre;
            if (command == PanelCommand::LevelModel)
                m_placement.level();
            m_output.leave = m_output.leave || command == PanelCommand::LeaveVr;
        },
        [&](const ShowPanel& panel) {
            m_panels.open(panel.kind, panel.isShown);
            m_mapping.setToolMenuOpen(m_panels.isOpen(PanelKind::Tools));
        },
        [&](LessonRequest request) { m_port->request(request); },
        [&](const ChooseChannel& channel) { m_mapping.selectChannel(channel.channel); },
        // discardsChanges is what the pressed item showed: the panel may be drawn before the latest changes.
        [&](const OpenFile& file) {
            m_port->request(OpenModel{file.path, file.discardsChanges});
        },
        [](const auto&) {},
    };
    hapticInput(side).stepped = true;
    std::visit(handler, action);
    if (const std::optional<DocumentRequest> request = requestOf(m_contents.parts(), action))
        m_port->request(*request);
    m_brush.change(changed(m_brush.state(), action));
    m_contents.apply(action);
    applySettings(SettingsPanel::after(m_settings, action));
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

void SculptClient::updateScene(const FrameInput& input)
{
    const BrushState& brush = m_brush.state();
    m_state.head = m_head;
    m_state.model = m_placement.matrix();
    m_state.box = m_update.box;
    m_state.shading = m_update.shading;
    m_state.isFlat = m_update.isFlat;
    m_state.hasTint = m_update.hasTint;
    m_state.hasCavity = m_update.hasCavity;
    m_state.symmetry = brush.stroke.symmetry;
    m_state.radial = brush.stroke.radial;
    m_state.hasFloor = m_settings.showsFloor;
    m_state.brush = {};
    if (!pointsAtPanel(m_settings.wands.sculpting))
        m_state.brush = shownAtTip(m_brush, m_mapping.task(), m_tip, m_placement);
    const bool usesTip = m_tip && !pointsAtPanel(m_settings.wands.sculpting);
    m_state.outline.clear();
    if (m_tube.isDrawing())
        m_tube.outlineTo(m_placement, m_state.outline);
    else if (const auto kind = outlinedAtTip(m_mapping.task(), m_contents.parts().shape); kind && usesTip)
        outlineOf(shapeAt(*kind, *m_tip, brush, m_placement), m_placement, m_state.outline);
    if (brush.stroke.symmetry != core::Symmetry::None)
        addMirrorImage(m_state.outline, brush.stroke.symmetry, m_placement);
    m_state.blade = {};
    if (m_mapping.task() == HandTask::Cut && usesTip)
        m_state.blade = Blade{m_tip->position, m_tip->forward(), bladeRadius, m_update.parts.size() == 1,
                              imageOfCut({*m_tip, HandTask::Cut, m_update.box}, brush, m_placement)};
    m_state.move = m_partHand.shown();
    m_state.translucent = m_update.translucent;
    const bool paints = brush.stroke.tool == core::Tool::Paint;
    m_state.brushColor = paints ? brush.stroke.color : SceneState().brushColor;
    for (const Side side : {Side::Left, Side::Right}) {
        const auto i = static_cast<std::size_t>(side);
        m_state.wands[i] = shownWand(input.wands[i], m_mapping, side);
        m_state.wands[i].joints = input.joints[i];
        m_state.wands[i].labels = m_labels.labels(side);
        if (paints && side == m_settings.wands.sculpting)
            m_state.wands[i].tip = brush.stroke.color;
    }
    m_state.spotlight = {};
    if (m_update.pointed)
        m_state.spotlight = Spotlight{
            m_placement.toRoom(m_update.pointed->position), m_placement.directionToRoom(m_update.pointed->normal),
            m_update.reducesMotion ? stillPhase : std::fmod(std::abs(input.seconds()), pulseSeconds) / pulseSeconds};
    m_state.teacher = {};
    if (m_update.teacher)
        m_state.teacher = core::Sphere{m_placement.toRoom(m_update.teacher->center),
                                       m_placement.lengthToRoom(m_update.teacher->radius)};
    m_panels.list(m_state.panels);
    m_state.lasers = {};
    for (const Side side : {Side::Left, Side::Right}) {
        const Pose tip = tipOf(input.wands[static_cast<std::size_t>(side)]);
        if (pointsAtPanel(side) && (m_panels.spot(side)->point - tip.position).dot(tip.forward()) > 0)
            m_state.lasers[static_cast<std::size_t>(side)] = Laser{tip.position, m_panels.spot(side)->point};
    }
    const auto marked = m_state.move ? m_partHand.vertices() : m_brush.footprint();
    if (std::exchange(m_tint, marked) != marked)
        m_scene.tint(m_tint.get());
}

/// Ends all actions and hides the user's avatar: the window must not wait for a hand that is gone, or show old
/// positions.
void SculptClient::idle()
{
    handle(m_mapping.releaseAll());
    m_port->show({});
}

void SculptClient::draw(std::size_t eye, const EyeImage& image, const EyeView& view)
{
    if (eye == 0)
        m_scene.prepare(m_state);
    EyeView own = view;
    own.framebuffer = m_target.framebufferFor(image);
    if (own.framebuffer == 0)
        return;
    m_scene.draw(own);
    m_target.resolve(image);
}
} // namespace vr
