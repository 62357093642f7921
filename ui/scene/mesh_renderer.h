#pragma once

#include "ui/scene/materials.h"
#include "ui/scene/mesh_buffer.h"
#include "ui/scene/orbit_camera.h"

#include "core/stroke/stroke.h"

#include <QSize>
#include <QVector4D>

#include <memory>

class QOpenGLShaderProgram;

namespace ui
{
/// What to draw, beside the clay itself.
struct MeshView
{
    Backdrop backdrop;
    core::Shading shading;
    bool flat = false;
    bool wireframe = false;
    bool tint = true;      ///< shows what the brush would move
    bool cavity = false;   ///< darkens valleys, lightens ridges
    QSize pixels;          ///< physical, of the framebuffer
    double pixelRatio = 1; ///< physical pixels to one logical pixel
};

/// Draws backdrop and clay with OpenGL 3.3 core into the framebuffer that is bound. The context that was current at
/// create() must be current at every call.
class MeshRenderer
{
public:
    MeshRenderer();
    ~MeshRenderer();

    /// False if a shader does not compile; the log is in the debug output.
    bool create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    MeshBuffer& meshBuffer() { return m_mesh; }

    /// A line where the plane through the origin with that unit normal cuts the clay; zero: none.
    void setCut(const core::Vec3& normal) { m_cutNormal = normal; }

    /// Tints what a spherical brush at `center` would move, mm, by its weights, with mirror images and in all sectors.
    void tintBall(const core::Vec3& center, const core::StrokeSettings& brush);
    void tintNothing();

    /// Clears depth; leaves depth test, culling and blending as OpenGL starts with.
    void draw(const OrbitCamera& camera, const MeshView& picture);

private:
    void drawBackdrop(const Backdrop& backdrop);
    void drawMesh(const OrbitCamera& camera, const MeshView& picture);
    void drawWires(const OrbitCamera& camera, const MeshView& picture);

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_meshProgram, m_wireProgram, m_backdropProgram;
    unsigned int m_noVertices = 0;
    core::Vec3 m_cutNormal = core::Vec3::Zero();
    QVector4D m_ball, m_ballImage; ///< centre and radius
    float m_ballFalloff = 0, m_ballCore = 0, m_sectors = 1;
    MeshBuffer m_mesh;
};
} // namespace ui
