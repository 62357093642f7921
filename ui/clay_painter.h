#pragma once

#include "clay_buffer.h"
#include "orbit_camera.h"

#include <QColor>

#include <memory>

class QOpenGLShaderProgram;

namespace ui
{
/// The two colours behind the model.
struct Backdrop
{
    QColor top, bottom;
};

/// Draws backdrop and clay with OpenGL 3.3 core into the framebuffer that is bound. The context that was current at
/// create() must be current at every call.
class ClayPainter
{
public:
    ClayPainter();
    ~ClayPainter();

    /// False if a shader does not compile; the log is in the debug output.
    bool create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    ClayBuffer& clay() { return m_clay; }

    /// A line where the plane through the origin with that unit normal cuts the clay; zero: none.
    void setCut(const core::Vec3& normal) { m_cutNormal = normal; }

    /// Clears depth; leaves depth test, culling and blending as OpenGL starts with.
    void draw(const OrbitCamera& camera, const Backdrop& backdrop);

private:
    void drawBackdrop(const Backdrop& backdrop);
    void drawClay(const OrbitCamera& camera);

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_clayProgram, m_backdropProgram;
    unsigned int m_noVertices = 0;
    core::Vec3 m_cutNormal = core::Vec3::Zero();
    ClayBuffer m_clay;
};
} // namespace ui
