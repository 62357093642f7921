#include "vr/scene/hidden_renderer.h"

#include <QOpenGLExtraFunctions>

namespace vr
{
bool HiddenRenderer::create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock)
{
    m_gl = gl;
    m_clock = clock;
    m_gl->glGenVertexArrays(1, &m_vertices);
    m_gl->glGenBuffers(1, &m_points);
    m_gl->glBindVertexArray(m_vertices);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, m_points);
    m_gl->glEnableVertexAttribArray(0);
    m_gl->glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector2f), nullptr);
    m_gl->glBindVertexArray(0);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, 0);
    return m_program.create(gl, "hidden.vert", "hidden.frag");
}

void HiddenRenderer::destroy()
{
    if (!m_gl)
        return;
    m_program.destroy();
    m_gl->glDeleteBuffers(1, &m_points);
    m_gl->glDeleteVertexArrays(1, &m_vertices);
    m_gl = nullptr;
}

/// Draws both sides of the triangles, because the runtime decides their winding.
void HiddenRenderer::draw(const HiddenArea& area, const Eigen::Matrix4f& projection)
{
    if (area.empty())
        return;
    m_program.use();
    m_program.projection.set(projection);
    m_gl->glDisable(GL_BLEND);
    m_gl->glDisable(GL_CULL_FACE);
    m_gl->glBindVertexArray(m_vertices);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, m_points);
    m_gl->glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(area.size() * sizeof(area[0])), area.data(),
                       GL_STREAM_DRAW);
    m_clock->run([&] { m_gl->glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(area.size())); });
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, 0);
    m_gl->glBindVertexArray(0);
}
} // namespace vr
