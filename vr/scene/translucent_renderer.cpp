#include "vr/scene/translucent_renderer.h"

#include "core/geometry/triangle_mesh.h"
#include "core/mesh/draw_arrays.h"

#include <QOpenGLExtraFunctions>

namespace vr
{
namespace
{
constexpr int ballSubdivisions = 4;
constexpr float farSide = 0.45F; ///< strength of a shell's far side, which is seen through its near side
constexpr float hiddenShell = 0.16F;
constexpr float planeBorder = 1.2F; ///< width of the border, pixels

core::DrawArrays unitBall()
{
    core::TriangleMesh mesh = core::icosphere(ballSubdivisions, 1);
    core::DrawArrays arrays;
    for (const core::Vec3f& point : mesh.points)
        arrays.vertices.push_back({point, {}, {}});
    arrays.faces = std::move(mesh.triangles);
    return arrays;
}
} // namespace

void TranslucentRenderer::RectangleProgram::place(const Rectangle& at) const
{
    center.set(at.center);
    halfX.set(at.halfX);
    halfY.set(at.halfY);
}

bool TranslucentRenderer::create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock)
{
    m_gl = gl;
    m_clock = clock;
    m_gl->glGenVertexArrays(1, &m_noVertices);
    m_ball.create(gl);
    m_ball.apply(core::wholePatchOf(unitBall()));
    const bool shell = m_shell.create(gl, "shell.vert", "shell.frag");
    const bool line = m_line.create(gl, "line.vert", "line.frag");
    const bool ring = m_ring.create(gl, "rectangle.vert", "ring.frag");
    const bool plane = m_plane.create(gl, "rectangle.vert", "plane.frag");
    const bool picture = m_picture.create(gl, "rectangle.vert", "picture.frag");
    return shell && line && ring && plane && picture;
}

void TranslucentRenderer::destroy()
{
    if (!m_gl)
        return;
    for (Program* program : std::initializer_list<Program*>{&m_shell, &m_line, &m_ring, &m_plane, &m_picture})
        program->destroy();
    m_ball.destroy();
    m_gl->glDeleteVertexArrays(1, &m_noVertices);
    m_gl = nullptr;
}

void TranslucentRenderer::draw(const EyeUniforms& eye, std::span<const TranslucentShape> sorted, DepthWrite depthWrite)
{
    m_gl->glDepthMask(depthWrite == DepthWrite::On ? GL_TRUE : GL_FALSE);
    setEye(eye);
    for (const TranslucentShape& item : sorted)
        std::visit([&](const auto& shape) { draw(shape); }, item.shape);
    m_gl->glBindVertexArray(0);
}

void TranslucentRenderer::setEye(const EyeUniforms& eye)
{
    m_shell.use();
    m_shell.view.set(eye.view);
    m_shell.projection.set(eye.projection);
    m_line.use();
    m_line.view.set(eye.view);
    m_line.projection.set(eye.projection);
    m_line.pixel.set(eye.pixel);
    m_ring.use();
    m_ring.clip.set(eye.clip);
    m_plane.use();
    m_plane.clip.set(eye.clip);
    m_plane.border.set(planeBorder);
    m_picture.use();
    m_picture.clip.set(eye.clip);
}

void TranslucentRenderer::draw(const Shell& shell)
{
    m_shell.use();
    m_shell.center.set(shell.center);
    m_shell.radius.set(shell.radius);
    m_shell.color.set(shell.color);
    m_gl->glEnable(GL_CULL_FACE);
    m_shell.strength.set(hiddenShell * shell.strength);
    m_gl->glDepthFunc(GL_GREATER);
    drawShell();
    m_gl->glDepthFunc(GL_LEQUAL);
    m_shell.strength.set(farSide * shell.strength);
    m_gl->glCullFace(GL_FRONT);
    drawShell();
    m_shell.strength.set(shell.strength);
    m_gl->glCullFace(GL_BACK);
    drawShell();
    m_gl->glDisable(GL_CULL_FACE);
}

void TranslucentRenderer::draw(const Line& line)
{
    m_line.use();
    m_line.from.set(line.from);
    m_line.to.set(line.to);
    m_line.halfWidth.set(line.width / 2);
    m_line.color.set(line.color);
    m_line.alphas.set(line.alphas);
    drawStrip();
}

void TranslucentRenderer::draw(const Ring& ring)
{
    m_ring.use();
    m_ring.place(ring.place);
    m_ring.inner.set(ring.hole);
    m_ring.sweep.set(ring.sweep);
    m_ring.color.set(ring.color);
    if (ring.hiddenAlpha > 0) {
        m_ring.alpha.set(ring.hiddenAlpha);
        m_gl->glDepthFunc(GL_GREATER);
        drawStrip();
        m_gl->glDepthFunc(GL_LEQUAL);
    }
    m_ring.alpha.set(ring.alpha);
    drawStrip();
}

void TranslucentRenderer::draw(const Plane& plane)
{
    m_plane.use();
    m_plane.place(plane.place);
    m_plane.color.set(plane.color);
    drawStrip();
}

void TranslucentRenderer::draw(const Picture& picture)
{
    m_picture.use();
    m_picture.place(picture.place);
    m_picture.picture.set(0);
    m_picture.opacity.set(picture.opacity);
    m_gl->glActiveTexture(GL_TEXTURE0);
    m_gl->glBindTexture(GL_TEXTURE_2D, picture.texture);
    drawStrip();
    m_gl->glBindTexture(GL_TEXTURE_2D, 0);
}

void TranslucentRenderer::drawShell()
{
    m_clock->run([&] { m_ball.draw(); });
}

void TranslucentRenderer::drawStrip()
{
    m_gl->glBindVertexArray(m_noVertices);
    m_clock->run([&] { m_gl->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); });
}
} // namespace vr
