#include "vr/scene/translucent_mesh.h"

#include <QOpenGLExtraFunctions>

namespace vr
{
namespace
{
const Eigen::Vector3f glassColor(0.393F, 0.604F, 0.871F); // linear light, 0 to 1
const Eigen::Vector2f glassAlphas(0.14F, 0.70F); // opacity where it faces the eye, and where it turns away, 0 to 1
constexpr float depthOffset = 2;                 // units of glPolygonOffset
} // namespace

bool TranslucentMesh::create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock)
{
    m_gl = gl;
    m_clock = clock;
    m_mesh.create(gl);
    return m_program.create(gl, "ghost.vert", "ghost.frag");
}

void TranslucentMesh::destroy()
{
    if (!m_gl)
        return;
    m_program.destroy();
    m_mesh.destroy();
    m_arrays.reset();
    m_gl = nullptr;
}

void TranslucentMesh::prepare(const std::shared_ptr<const core::DrawArrays>& arrays)
{
    if (m_arrays != arrays) {
        m_mesh.apply(core::wholePatchOf(arrays ? *arrays : core::DrawArrays()));
        m_arrays = arrays;
    }
    m_mesh.step();
}

/// Moves the mesh a little away from the eye, so that it does not flicker where it lies on the surface of the result.
void TranslucentMesh::draw(const EyeUniforms& eye, const Eigen::Matrix4f& toRoom)
{
    if (!m_arrays || m_mesh.isLoading())
        return;
    m_program.use();
    m_program.place.set(Eigen::Matrix4f(eye.view * toRoom));
    m_program.projection.set(eye.projection);
    m_program.color.set(glassColor);
    m_program.alphas.set(glassAlphas);
    m_gl->glDisable(GL_CULL_FACE);
    m_gl->glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl->glPolygonOffset(depthOffset, depthOffset);
    m_clock->run([&] { m_mesh.shown().draw(); });
    m_gl->glDisable(GL_POLYGON_OFFSET_FILL);
}
} // namespace vr
