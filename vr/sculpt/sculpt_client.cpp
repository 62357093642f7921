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
core::Sphere clayOf(const Room& room, const core::Box& box)
{
    return {room.middle(), box.isEmpty() ? 0 : room.lengthToRoom(box.sizes().maxCoeff()) / 2};
}
} // namespace

SculptClient::SculptClient(std::shared_ptr<DocumentPort> port, const HeadsetChoice& choice)
    : m_port(std::move(port))
    , m_choice(choice)
    , m_hands(choice.hands)
    , m_brush(m_port.get())
    , m_haptics(choice.feel)
{}

SculptClient::~SculptClient() = default;

bool SculptClient::create(QOpenGLContext& context)
{
    QOpenGLExtraFunctions* gl = context.extraFunctions();
    m_target.create(gl);
    m_wall.create(gl);
    return m_scene.create(gl);
}

void SculptClient::destroy()
{
    obey(m_hands.letGo());
    m_scene.destroy();
    m_wall.destroy();
    m_target.destroy();
}

/// Panels know where the wands were when they decide where these point; hands know whether they point at one; the brush is looked at when
/// it is known what it is and where.
FrameOutput SculptClient::frame(const FrameInput& input)
{
    m_output = {};
    m_feelings = {};
    takeNews();
    takePatch();
    moveRoom(input);
    place(input);
    aimAtPanels(input);
    const HandsFrame frame = handsFrame(input);
    const std::vector<HandCommand> commands = m_hands.step(frame);
    obey(commands);
    m_brush.look(m_room);
    feelEffects();
    m_labels.step(frame, m_head, m_hands, commands);
    showPanels(input);
    see(input);
    tellPresence(input);
    m_output.pulses = m_haptics.step(input.seconds(), m_feelings);
    return m_output;
}

/// Another model is placed before the person; one that has only grown stays where it is. The hand feels what the window chose for it.
void SculptClient::takeNews()
{
    std::optional<DocumentNews> news = m_port->takeNews();
    if (!news)
        return;
    const bool isAnother = news->model != m_news.model;
    const bool isFirst = m_news.brushChange == 0;
    const bool isChosen = news->brushChange != m_news.brushChange || news->radiusChange != m_news.radiusChange;
    feeling(m_choice.hands.sculpting).stepped = isChosen && !isFirst;
    if (!isSameStep(news->lesson, m_news.lesson))
        m_lessonPage = 0;
    m_news = *std::move(news);
    m_room.setModel(m_news.box);
    m_brush.take(m_news, m_room);
    m_isPlaced = m_isPlaced && !isAnother;
    m_files.folder = m_news.folder;
    m_files.files = m_news.files;
    m_files.hasUnsavedChanges = m_news.isModified;
    m_files.isBusy = m_news.isBusy;
    m_files.saved = m_news.saved;
}

void SculptClient::takePatch()
{
    if (std::optional<core::MeshPatch> patch = m_port->takePatch())
        m_scene.apply(*std::move(patch));
}

void SculptClient::moveRoom(const FrameInput& input)
{
    if (input.head)
        m_head = *input.head;
    if (!input.roomMoved)
        return;
    obey(m_hands.letGo());
    m_wall.forgetPlaces();
    m_isPlaced = false;
}

/// The model that is still shown stays where it is until the next one is there whole.
void SculptClient::place(const FrameInput& input)
{
    if (!m_isPlaced && input.head && !m_scene.isLoading()) {
        m_room.place(m_head, m_choice.raised);
        m_isPlaced = true;
    }
    PanelWall::Sight sight{m_head, {}, m_choice.hands.sculpting, clayOf(m_room, m_news.box), m_choice.hands.preset == Preset::OneHand};
    for (std::size_t i = 0; i < sideCount; ++i)
        if (input.wands[i].isTracked)
            sight.grips[i] = input.wands[i].grip;
    m_wall.place(sight);
}

void SculptClient::aimAtPanels(const FrameInput& input)
{
    const WandState& sculpting = input.wands[static_cast<std::size_t>(m_choice.hands.sculpting)];
    m_tip = sculpting.isTracked ? std::optional(tipOf(sculpting)) : std::nullopt;
    m_brush.aim(m_tip);
    for (const Side side : {Side::Left, Side::Right}) {
        const WandState& wand = input.wands[static_cast<std::size_t>(side)];
        const Pose tip = tipOf(wand);
        const std::optional<core::Ray> ray =
            wand.isTracked ? std::optional(core::Ray{tip.position, tip.forward()}) : std::nullopt;
        if (const std::optional<PanelAction> action = m_wall.aim(side, ray, input.seconds()))
            obey(side, *action);
    }
}

/// A brush that is in the clay sculpts, whatever stands behind it; so does a ray that meets the clay before it meets a panel.
bool SculptClient::pointsAtPanel(Side side) const
{
    const std::optional<PanelPointer::Spot>& spot = m_wall.spot(side);
    if (!spot || m_hands.draws(side))
        return false;
    if (side != m_choice.hands.sculpting || !m_tip)
        return true;
    const std::optional<double> reach = m_brush.reach(m_room);
    return !m_brush.touches(m_room) && !(reach && *reach < (spot->point - m_tip->position).norm());
}

HandsFrame SculptClient::handsFrame(const FrameInput& input) const
{
    return {input.seconds(), input.wands, {pointsAtPanel(Side::Left), pointsAtPanel(Side::Right)}};
}

void SculptClient::feelEffects()
{
    const Side side = m_choice.hands.sculpting;
    const StrokeEffect effect = m_port->takeEffect();
    feeling(side).touches = m_brush.touches(m_room);
    feeling(side).pressure = m_brush.touches(m_room) ? m_brush.pressure() : 0;
    feeling(side).fused = feeling(side).fused || effect.fusions > 0;
    feeling(side).refused = feeling(side).refused || effect.refusals > 0;
    for (const Side each : {Side::Left, Side::Right})
        if (const std::optional<Hands::Hold> hold = m_hands.hold(each))
            feeling(each).hold = hold->progress;
}

/// Nobody at the window waits for the end of a stroke whose hand is gone, or looks at whom the wands lay before.
void SculptClient::rest()
{
    obey(m_hands.letGo());
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
