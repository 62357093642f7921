// First what hides (clay, wands), then the dome behind it, then what is seen through: floor, panels, and the rest from far to near.
#include "vr/scene/scene.h"

#include "vr/scene/mesh_buffer.h"
#include "vr/scene/mesh_program.h"
#include "vr/scene/mesh_stream.h"
#include "vr/scene/translucent_list.h"
#include "vr/scene/translucent_renderer.h"
#include "vr/scene/label_layout.h"
#include "vr/scene/room_renderer.h"
#include "vr/scene/wand_renderer.h"

#include "core/stroke/symmetry_plane.h"

#include <QOpenGLExtraFunctions>

#include <cassert>
#include <cmath>

namespace vr
{
/// What of the state the clay's shader takes.
struct ClayLook
{
    Eigen::Matrix4f toRoom = Eigen::Matrix4f::Identity();
    core::Shading shading;
    bool isFlat = false;
    Eigen::Vector3f cutNormal = Eigen::Vector3f::Zero();
    Eigen::Vector4f ball = Eigen::Vector4f::Zero(), ballImage = Eigen::Vector4f::Zero(); ///< centre and radius, mm
    float ballFalloff = 0, sectors = 1;
};

namespace
{
constexpr double leastLevel = 0.2;   ///< of the head's sideways axis, to be taken as level
constexpr double shadeReach = 0.9;   ///< metres: what hangs higher hardly shades the floor
constexpr float strongestShade = 0.5F;

ClayLook clayLook(const SceneState& state)
{
    ClayLook look;
    look.toRoom = state.model.matrix().cast<float>();
    look.shading = state.shading;
    look.isFlat = state.isFlat;
    const core::Vec3 normal = core::planeNormal(state.symmetry);
    look.cutNormal = normal.cast<float>();
    look.sectors = static_cast<float>(state.radial);
    if (const auto* brush = std::get_if<BallBrush>(&state.brush)) {
        const core::Vec3 center = state.model.inverse() * brush->center;
        const double radius = brush->radius / std::cbrt(state.model.linear().determinant());
        look.ball << center.cast<float>(), static_cast<float>(radius);
        look.ballImage << (center - 2 * normal * normal.dot(center)).cast<float>(), static_cast<float>(normal.isZero() ? 0 : radius);
        look.ballFalloff = static_cast<float>(brush->falloff);
    }
    return look;
}

/// The lights stand behind who looks at the model from there, over the left shoulder, as on the desktop: they go around it with the head and
/// do not turn or roll with it, or the shades would swim.
Eigen::Matrix3f lightAxes(const SceneState& state)
{
    Pose head = state.head;
    const core::Vec3 sideways = head.rotation * core::Vec3::UnitX(), level(sideways.x(), 0, sideways.z());
    if (level.norm() > leastLevel)
        head.rotation = Eigen::AngleAxisd(std::atan2(-level.z(), level.x()), core::Vec3::UnitY());
    const core::Vec3 middle = state.box.isEmpty() ? state.model.translation() : core::Vec3(state.model * state.box.center());
    return axesFacing(head, middle).cast<float>();
}

FloorShade floorShade(const SceneState& state)
{
    FloorShade shade;
    if (state.box.isEmpty())
        return shade;
    const core::Box box = state.box.transformed(state.model);
    const double height = std::max(box.min().y(), 0.0);
    shade.under = core::Vec3(box.center().x(), 0, box.center().z()).cast<float>();
    shade.halfSize = ((1 + height) * 0.5 * Eigen::Vector2d(box.sizes().x(), box.sizes().z())).cast<float>();
    shade.strength = strongestShade * static_cast<float>(std::exp(-height / shadeReach));
    return shade;
}
} // namespace

struct Scene::State
{
    QOpenGLExtraFunctions* gl = nullptr;
    DrawClock clock;
    ClayStream<MeshBuffer> clay;
    ClayProgram clayProgram;
    WandPainter wandPainter;
    RoomPainter roomPainter;
    GlassPainter glassPainter;
    LabelPictures labels;

    // Of the frame.
    ClayLook look;
    Eigen::Matrix3f lights = Eigen::Matrix3f::Identity();
    FloorShade shade;
    bool hasFloor = true;
    std::array<ShownWand, sideCount> wands;
    GlassLists glass;

    EyeFrame frameOf(const EyeView& eye) const;
    void drawOpaque(const EyeFrame& eye);
    void drawGlass(const EyeFrame& eye);
};

EyeFrame Scene::State::frameOf(const EyeView& eye) const
{
    EyeFrame frame;
    frame.view = eye.view.matrix();
    frame.projection = eye.projection;
    frame.clip = eye.projection * frame.view;
    frame.eye = eye.view.inverse().translation();
    frame.up = eye.view.linear().col(1);
    frame.lights = eye.view.linear() * lights;
    frame.pixel = 2 / (eye.projection(1, 1) * static_cast<float>(eye.height));
    return frame;
}

void Scene::State::drawOpaque(const EyeFrame& eye)
{
    gl->glDisable(GL_BLEND);
    gl->glEnable(GL_CULL_FACE);
    clayProgram.useFor(eye);
    for (const ShownWand& wand : wands)
        wandPainter.draw(eye, clayProgram, wand);
    clayProgram.flatShading.set(look.isFlat ? 1 : 0);
    clayProgram.cut.set(look.cutNormal.isZero() ? 0.0F : 1.0F);
    clayProgram.cutNormal.set(look.cutNormal);
    clayProgram.ball.set(look.ball);
    clayProgram.ballImage.set(look.ballImage);
    clayProgram.ballFalloff.set(look.ballFalloff);
    clayProgram.sectors.set(look.sectors);
    clayProgram.place(eye, look.toRoom);
    clayProgram.shade(look.shading);
    clock.run([&] { clay.shown().draw(); });
    gl->glDisable(GL_CULL_FACE);
    roomPainter.drawDome(eye);
}

void Scene::State::drawGlass(const EyeFrame& eye)
{
    gl->glEnable(GL_BLEND);
    gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->glDepthMask(GL_FALSE);
    if (hasFloor)
        roomPainter.drawFloor(eye, shade);
    glassPainter.draw(eye, glass.panels, GlassPainter::Hides::Yes);
    glassPainter.draw(eye, glass.others, GlassPainter::Hides::No);
    gl->glDepthMask(GL_TRUE);
    gl->glDisable(GL_BLEND);
}

Scene::Scene() : m_state(std::make_unique<State>()) {}

Scene::~Scene() = default;

bool Scene::create(QOpenGLExtraFunctions* gl)
{
    State& s = *m_state;
    s.gl = gl;
    s.clay.create(gl);
    s.wandPainter.create(gl, &s.clock);
    s.labels.create(gl);
    const bool clay = s.clayProgram.create(gl);
    const bool room = s.roomPainter.create(gl, &s.clock);
    const bool glass = s.glassPainter.create(gl, &s.clock);
    return clay && room && glass;
}

void Scene::destroy()
{
    State& s = *m_state;
    s.clay.destroy();
    s.clayProgram.destroy();
    s.wandPainter.destroy();
    s.roomPainter.destroy();
    s.glassPainter.destroy();
    s.labels.destroy();
}

void Scene::apply(core::MeshPatch patch)
{
    m_state->clay.apply(std::move(patch));
}

bool Scene::isLoading() const
{
    return m_state->clay.isLoading();
}

void Scene::tint(const core::Footprint* footprint)
{
    m_state->clay.shown().tint(isLoading() ? nullptr : footprint);
}

void Scene::prepare(const SceneState& state)
{
    assert(state.model.linear().determinant() > 0);
    State& s = *m_state;
    s.clay.step();
    s.look = clayLook(state);
    s.lights = lightAxes(state);
    s.shade = floorShade(state);
    s.hasFloor = state.hasFloor;
    s.wands = state.wands;
    s.labels.startFrame();
    listGlass(state, s.labels, s.glass);
}

void Scene::draw(const EyeView& eye)
{
    State& s = *m_state;
    const EyeFrame frame = s.frameOf(eye);
    s.gl->glBindFramebuffer(GL_FRAMEBUFFER, eye.framebuffer);
    s.gl->glViewport(0, 0, eye.width, eye.height);
    s.gl->glEnable(GL_FRAMEBUFFER_SRGB); // does nothing to an image of linear light
    s.gl->glDisable(GL_SCISSOR_TEST);
    s.gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    s.gl->glEnable(GL_DEPTH_TEST);
    s.gl->glDepthFunc(GL_LEQUAL);
    s.gl->glDepthMask(GL_TRUE);
    s.gl->glCullFace(GL_BACK);
    s.gl->glFrontFace(GL_CCW);
    s.gl->glClearDepthf(1);
    s.gl->glClearColor(0, 0, 0, 1);
    s.clock.run([&] { s.gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); });
    s.drawOpaque(frame);
    s.drawGlass(frame);
}

std::uint64_t Scene::clayBytes() const
{
    return m_state->clay.bytes();
}

std::uint64_t Scene::wholeUploads() const
{
    return m_state->clay.wholeUploads();
}

double Scene::drawCallMs() const
{
    return m_state->clock.milliseconds();
}

unsigned long Scene::drawCalls() const
{
    return m_state->clock.calls();
}
} // namespace vr
