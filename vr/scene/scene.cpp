// Order of drawing: the area that the lens hides, then wands and mesh, then the dome behind them unless the real room
// is seen there, then the translucent floor and mesh, panels and other shapes, the last two from far to near.
#include "vr/scene/scene.h"

#include "vr/scene/hidden_renderer.h"
#include "vr/scene/label_layout.h"
#include "vr/scene/mesh_buffer.h"
#include "vr/scene/mesh_program.h"
#include "vr/scene/mesh_stream.h"
#include "vr/scene/room_renderer.h"
#include "vr/scene/translucent_list.h"
#include "vr/scene/translucent_mesh.h"
#include "vr/scene/translucent_renderer.h"
#include "vr/scene/wand_renderer.h"

#include "core/stroke/symmetry_plane.h"

#include <QOpenGLExtraFunctions>

#include <cassert>
#include <cmath>

namespace vr
{
/// The part of the state that the mesh's shader needs.
struct MeshAppearance
{
    Eigen::Matrix4f toRoom = Eigen::Matrix4f::Identity();
    core::Shading shading;
    bool isFlat = false, hasTint = true, hasCavity = false;
    CutPlane cut; ///< plane of symmetry, or that of the blade
    Eigen::Vector4f ball = Eigen::Vector4f::Zero(), ballImage = Eigen::Vector4f::Zero(); ///< centre and radius, mm
    float ballFalloff = 0, ballCore = 0, sectors = 1;
    std::optional<core::TransformUniforms> move;
};

namespace
{
/// Shortest horizontal projection of the head's right axis (a unit vector) from which the head's yaw is computed.
constexpr double minLevel = 0.2;
constexpr double shadeReach = 0.9; ///< height above the floor at which the shade falls to 1/e, metres
constexpr float strongestShade = 0.5F;

MeshAppearance meshAppearance(const SceneState& state)
{
    MeshAppearance look;
    look.toRoom = state.model.matrix().cast<float>();
    look.shading = state.shading;
    look.isFlat = state.isFlat;
    look.hasTint = state.hasTint;
    look.hasCavity = state.hasCavity;
    const core::Vec3 normal = core::planeNormal(state.symmetry);
    look.cut.normal = normal.cast<float>();
    if (state.blade) {
        const Eigen::Affine3d toModel = state.model.inverse();
        look.cut = {(toModel * state.blade->center).cast<float>(),
                    (toModel.linear() * state.blade->normal).normalized().cast<float>(), state.blade->tints,
                    state.blade->image};
    }
    look.sectors = static_cast<float>(state.radial);
    if (state.move)
        look.move = core::uniformsOf(*state.move);
    if (const auto* brush = std::get_if<BallBrush>(&state.brush)) {
        const core::Vec3 center = state.model.inverse() * brush->center;
        const double radius = brush->radius / std::cbrt(state.model.linear().determinant());
        look.ball << center.cast<float>(), static_cast<float>(radius);
        look.ballImage << (center - 2 * normal * normal.dot(center)).cast<float>(),
            static_cast<float>(normal.isZero() ? 0 : radius);
        look.ballFalloff = static_cast<float>(brush->falloff);
        look.ballCore = static_cast<float>(brush->core);
    }
    return look;
}

/// Returns the axes of the lights. As on the desktop, the lights are behind the viewer, over the left shoulder. They
/// follow the head around the model, but do not turn or roll with it, because the shading would swim.
Eigen::Matrix3f lightAxes(const SceneState& state)
{
    Pose head = state.head;
    const core::Vec3 sideways = head.rotation * core::Vec3::UnitX(), level(sideways.x(), 0, sideways.z());
    if (level.norm() > minLevel)
        head.rotation = Eigen::AngleAxisd(std::atan2(-level.z(), level.x()), core::Vec3::UnitY());
    const core::Vec3 middle =
        state.box.isEmpty() ? state.model.translation() : core::Vec3(state.model * state.box.center());
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
    DrawCallTimer clock;
    MeshStream<MeshBuffer> mesh;
    MeshProgram meshProgram;
    WandRenderer wandRenderer;
    HiddenRenderer hiddenRenderer;
    RoomRenderer roomRenderer;
    TranslucentMesh translucentMesh;
    TranslucentRenderer translucentRenderer;
    LabelTextures labels;

    // State of the present frame.
    MeshAppearance look;
    Eigen::Matrix3f lights = Eigen::Matrix3f::Identity();
    FloorShade shade;
    bool hasFloor = true;
    std::array<ShownWand, sideCount> wands;
    TranslucentList translucent;

    EyeUniforms uniformsOf(const EyeView& eye) const;
    void drawOpaque(const EyeUniforms& eye, bool hasDome);
    void drawTranslucent(const EyeUniforms& eye);
};

EyeUniforms Scene::State::uniformsOf(const EyeView& eye) const
{
    EyeUniforms uniforms;
    uniforms.view = eye.view.matrix();
    uniforms.projection = eye.projection;
    uniforms.clip = eye.projection * uniforms.view;
    uniforms.eye = eye.view.inverse().translation();
    uniforms.up = eye.view.linear().col(1);
    uniforms.lights = eye.view.linear() * lights;
    uniforms.pixel = 2 / (eye.projection(1, 1) * static_cast<float>(eye.height));
    return uniforms;
}

void Scene::State::drawOpaque(const EyeUniforms& eye, bool hasDome)
{
    gl->glDisable(GL_BLEND);
    gl->glEnable(GL_CULL_FACE);
    meshProgram.useFor(eye);
    for (const ShownWand& wand : wands)
        wandRenderer.draw(eye, meshProgram, wand);
    meshProgram.flatShading.set(look.isFlat ? 1 : 0);
    meshProgram.cutAlong(eye, look.toRoom, look.cut);
    meshProgram.tintBalls(eye, look.toRoom, look.ball, look.ballImage);
    meshProgram.ballFalloff.set(look.ballFalloff);
    meshProgram.ballCore.set(look.ballCore);
    meshProgram.setSectors(look.sectors);
    meshProgram.tinted.set(look.hasTint ? 1.0F : 0.0F);
    meshProgram.cavity.set(look.hasCavity ? 1.0F : 0.0F);
    if (look.move)
        meshProgram.move(*look.move);
    meshProgram.place(eye, look.toRoom);
    meshProgram.shade(look.shading);
    clock.run([&] { mesh.shown().draw(); });
    gl->glDisable(GL_CULL_FACE);
    if (hasDome)
        roomRenderer.drawDome(eye);
}

void Scene::State::drawTranslucent(const EyeUniforms& eye)
{
    gl->glEnable(GL_BLEND);
    gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->glDepthMask(GL_FALSE);
    if (hasFloor)
        roomRenderer.drawFloor(eye, shade);
    translucentMesh.draw(eye, look.toRoom);
    translucentRenderer.draw(eye, translucent.panels, TranslucentRenderer::DepthWrite::On);
    translucentRenderer.draw(eye, translucent.others, TranslucentRenderer::DepthWrite::Off);
    gl->glDepthMask(GL_TRUE);
    gl->glDisable(GL_BLEND);
}

Scene::Scene() : m_state(std::make_unique<State>()) {}

Scene::~Scene() = default;

bool Scene::create(QOpenGLExtraFunctions* gl)
{
    State& s = *m_state;
    s.gl = gl;
    s.mesh.create(gl);
    s.wandRenderer.create(gl, &s.clock);
    s.labels.create(gl);
    const bool mesh = s.meshProgram.create(gl);
    const bool hidden = s.hiddenRenderer.create(gl, &s.clock);
    const bool room = s.roomRenderer.create(gl, &s.clock);
    const bool translucentMesh = s.translucentMesh.create(gl, &s.clock);
    const bool translucent = s.translucentRenderer.create(gl, &s.clock);
    return mesh && hidden && room && translucentMesh && translucent;
}

void Scene::destroy()
{
    State& s = *m_state;
    s.mesh.destroy();
    s.meshProgram.destroy();
    s.wandRenderer.destroy();
    s.hiddenRenderer.destroy();
    s.roomRenderer.destroy();
    s.translucentMesh.destroy();
    s.translucentRenderer.destroy();
    s.labels.destroy();
}

void Scene::apply(core::MeshPatch patch)
{
    m_state->mesh.apply(std::move(patch));
}

bool Scene::isLoading() const
{
    return m_state->mesh.isLoading();
}

void Scene::tint(const core::Footprint* footprint)
{
    m_state->mesh.shown().tint(isLoading() ? nullptr : footprint);
}

void Scene::prepare(const SceneState& state)
{
    assert(state.model.linear().determinant() > 0);
    State& s = *m_state;
    s.mesh.step();
    s.translucentMesh.prepare(state.translucent);
    s.look = meshAppearance(state);
    s.lights = lightAxes(state);
    s.shade = floorShade(state);
    s.hasFloor = state.hasFloor;
    s.wands = state.wands;
    s.labels.startFrame();
    buildTranslucentList(state, s.labels, s.translucent);
}

void Scene::draw(const EyeView& eye)
{
    State& s = *m_state;
    const EyeUniforms uniforms = s.uniformsOf(eye);
    s.gl->glBindFramebuffer(GL_FRAMEBUFFER, eye.framebuffer);
    s.gl->glViewport(0, 0, eye.width, eye.height);
    s.gl->glEnable(GL_FRAMEBUFFER_SRGB); // has no effect on an image of linear light
    s.gl->glDisable(GL_SCISSOR_TEST);
    s.gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    s.gl->glEnable(GL_DEPTH_TEST);
    s.gl->glDepthFunc(GL_LEQUAL);
    s.gl->glDepthMask(GL_TRUE);
    s.gl->glCullFace(GL_BACK);
    s.gl->glFrontFace(GL_CCW);
    s.gl->glClearDepthf(1);
    s.gl->glClearColor(0, 0, 0, eye.hasPassthrough ? 0 : 1);
    s.clock.run([&] { s.gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); });
    if (eye.hidden)
        s.hiddenRenderer.draw(*eye.hidden, eye.projection);
    s.drawOpaque(uniforms, !eye.hasPassthrough);
    s.drawTranslucent(uniforms);
}

std::uint64_t Scene::meshBytes() const
{
    return m_state->mesh.bytes();
}

std::uint64_t Scene::wholeUploads() const
{
    return m_state->mesh.wholeUploads();
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
