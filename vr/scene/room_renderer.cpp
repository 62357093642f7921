#include "vr/scene/room_renderer.h"

#include <QOpenGLExtraFunctions>

namespace vr
{
namespace
{
// Colours of the background. They are dark but never black: on some displays moving objects leave black trails.
const Eigen::Vector3f topColor(0.200F, 0.212F, 0.232F), horizonColor(0.298F, 0.314F, 0.340F),
    bottomColor(0.168F, 0.176F, 0.192F);              // sRGB, 0 to 1
const Eigen::Vector3f lineColor(0.50F, 0.54F, 0.60F); // linear light, 0 to 1
constexpr float lineAlpha = 0.16F;
/// Distance between the lines of the grid, and radius of the grid, metres. Every tenth line is stronger.
constexpr float cell = 0.1F, reach = 5;
} // namespace

bool RoomRenderer::create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock)
{
    m_gl = gl;
    m_clock = clock;
    m_gl->glGenVertexArrays(1, &m_noVertices);
    const bool dome = m_dome.create(gl, "dome.vert", "dome.frag");
    return m_floor.create(gl, "rectangle.vert", "ground.frag") && dome;
}

void RoomRenderer::destroy()
{
    if (!m_gl)
        return;
    m_dome.destroy();
    m_floor.destroy();
    m_gl->glDeleteVertexArrays(1, &m_noVertices);
    m_gl = nullptr;
}

void RoomRenderer::drawDome(const EyeUniforms& eye)
{
    m_dome.use();
    m_dome.view.set(eye.view);
    m_dome.projection.set(eye.projection);
    m_dome.top.set(topColor);
    m_dome.horizon.set(horizonColor);
    m_dome.bottom.set(bottomColor);
    m_gl->glBindVertexArray(m_noVertices);
    m_clock->run([&] { m_gl->glDrawArrays(GL_TRIANGLES, 0, 3); });
    m_gl->glBindVertexArray(0);
}

void RoomRenderer::drawFloor(const EyeUniforms& eye, const FloorShade& shade)
{
    m_floor.use();
    m_floor.clip.set(eye.clip);
    m_floor.center.set(Eigen::Vector3f(0, 0, 0));
    m_floor.halfX.set(Eigen::Vector3f(reach, 0, 0));
    m_floor.halfY.set(Eigen::Vector3f(0, 0, -reach));
    m_floor.eyePosition.set(eye.eye);
    m_floor.viewMatrix.set(eye.view);
    m_floor.projectionMatrix.set(eye.projection);
    m_floor.cell.set(cell);
    m_floor.reach.set(reach);
    m_floor.under.set(shade.under);
    m_floor.footprint.set(shade.halfSize);
    m_floor.lineColor.set(lineColor);
    m_floor.lineAlpha.set(lineAlpha);
    m_floor.shade.set(shade.strength);
    m_gl->glBindVertexArray(m_noVertices);
    m_clock->run([&] { m_gl->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); });
    m_gl->glBindVertexArray(0);
}
} // namespace vr
