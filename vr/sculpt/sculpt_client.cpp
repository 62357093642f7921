#include "vr/sculpt/sculpt_client.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

namespace vr
{
namespace
{
bool isSameStep(const std::optional<LessonPanel>& a, const std::optional<LessonPanel>& b)
{
    return a && b && a->lesson == b->lesson && a->step == b->step;
}

/// What panels ahead do not hide: a ball about the model's middle.
core::Sphere modelSphere(const ModelPlacement& placement, const core::Box& box)
{
    return {placement.middle(), box.isEmpty() ? 0 : placement.lengthToRoom(box.sizes().maxCoeff()) / 2};
}
} // namespace

SculptClient::SculptClient(std::shared_ptr<DocumentPort> port, const HeadsetSettings& settings)
    : m_port(std::move(port))
    , m_settings(settings)
    , m_mapping(settings.wands)
    , m_brush(m_port.get())
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

/// Panels know where the wands were when they decide where these point; hands know whether they point at one; the brush
/// is looked at when it is known what it is and where.
FrameOutput SculptClient::frame(const FrameInput& input)
{
    m_output = {};
    m_hapticInputs = {};
    takeUpdate();
    takePatch();
    handleRoomChange(input);
    place(input);
    aimAtPanels(input);
    const InputFrame frame = inputFrame(input);
    const std::vector<WandCommand> commands = m_mapping.step(frame);
    handle(commands);
    m_brush.querySurface(m_placement);
    updateHaptics();
    m_labels.step(frame, m_head, m_mapping, commands);
    showPanels(input);
    updateScene(input);
    publishAvatar(input);
    m_output.pulses = m_haptics.step(input.seconds(), m_hapticInputs);
    return m_output;
}

/// Another model is placed before the person; one that has only grown stays where it is. The hand feels what the window
/// chose for it.
void SculptClient::takeUpdate()
{
    std::optional<DocumentUpdate> update = m_port->takeUpdate();
    if (!update)
        return;
    const bool isAnother = update->model != m_update.model;
    const bool isFirst = m_update.brushChange == 0;
    const bool isChosen = update->brushChange != m_update.brushChange || update->radiusChange != m_update.radiusChange;
    hapticInput(m_settings.wands.sculpting).stepped = isChosen && !isFirst;
    if (!isSameStep(update->lesson, m_update.lesson))
        m_lessonPage = 0;
    m_update = *std::move(update);
    m_placement.setModel(m_update.box);
    m_brush.take(m_update, m_placement);
    m_isPlaced = m_isPlaced && !isAnother;
    m_files.folder = m_update.folder;
    m_files.files = m_update.files;
    m_files.hasUnsavedChanges = m_update.isModified;
    m_files.isBusy = m_update.isBusy;
    m_files.saved = m_update.saved;
}

void SculptClient::takePatch()
{
    if (std::optional<core::MeshPatch> patch = m_port->takePatch())
        m_scene.apply(*std::move(patch));
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

/// The model that is still shown stays where it is until the next one is there whole.
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
        const Pose tip = tipOf(wand);
        const std::optional<core::Ray> ray =
            wand.isTracked ? std::optional(core::Ray{tip.position, tip.forward()}) : std::nullopt;
        if (const std::optional<PanelAction> action = m_panels.aim(side, ray, input.seconds()))
            handle(side, *action);
    }
}

/// A brush that is in the model sculpts, whatever is behind it; so does a ray that meets the model before a panel.
bool SculptClient::pointsAtPanel(Side side) const
{
    const std::optional<PanelPointer::Spot>& spot = m_panels.spot(side);
    if (!spot || m_mapping.isDrawing(side))
        return false;
    if (side != m_settings.wands.sculpting || !m_tip)
        return true;
    const std::optional<double> reach = m_brush.reach(m_placement);
    return !m_brush.touches(m_placement) && !(reach && *reach < (spot->point - m_tip->position).norm());
}

InputFrame SculptClient::inputFrame(const FrameInput& input) const
{
    return {input.seconds(), input.wands, {pointsAtPanel(Side::Left), pointsAtPanel(Side::Right)}};
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

/// Nobody at the window waits for the end of a stroke whose hand is gone, or looks at whom the wands lay before.
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
