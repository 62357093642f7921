#pragma once

#include "ui/scene/materials.h"
#include "ui/scene/mesh_buffer.h"
#include "ui/scene/orbit_camera.h"

#include "core/render/transform_uniforms.h"
#include "core/stroke/stroke.h"

#include <QSize>
#include <QVector4D>

#include <memory>
#include <optional>

class QOpenGLShaderProgram;

namespace ui
{
/// Options of a frame, besides the mesh itself.
struct MeshView
{
    Backdrop backdrop;
    core::Shading shading;
    bool flat = false;
    bool wireframe = false;
    bool tint = true;      ///< colours the vertices that the brush would move
    bool cavity = false;   ///< darkens valleys, lightens ridges
    QSize pixels;          ///< size of the framebuffer, physical pixels
    double pixelRatio = 1; ///< physical pixels per logical pixel
};

/// Draws backdrop and clay with OpenGL 3.3 core into the bound framebuffer. Thread: the OpenGL context that was current
/// at create() must be current at every call.
class MeshRenderer
{
public:
    MeshRenderer();
    ~MeshRenderer();

    /// Returns false if a shader does not compile; the log is in the debug output.
    bool create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    MeshBuffer& meshBuffer() { return m_mesh; }

    /// A plane that cuts the clay.
    struct Cut
    {
        core::Vec3 normal = core::Vec3::Zero(); ///< unit length; zero: no plane
        core::Vec3 point = core::Vec3::Zero();  ///< of the plane, mm
        /// Only marked vertices (MeshBuffer::tint()) are cut, and those on the positive side are tinted.
        bool tints = false;
        /// About which the plane's mirror image has a part in the cut; None: it has not.
        core::Symmetry image = core::Symmetry::None;
    };
    /// Draws a line where a plane cuts the clay.
    void setCut(const Cut& cut) { m_cut = cut; }

    /// Tints the vertices that a spherical brush at `center` (mm) would move, by their weights, in all sectors and with
    /// mirror images.
    void tintBall(const core::Vec3& center, const core::StrokeSettings& brush);
    void tintNothing();

    /// Shows the tinted vertices (MeshBuffer::tint()) not tinted, but moved by a transformation; nullopt: as they are.
    void move(const std::optional<core::TransformUniforms>& by) { m_move = by; }

    /// Draws one frame. Clears the depth buffer first; resets depth test, culling and blending to OpenGL's defaults.
    void draw(const OrbitCamera& camera, const MeshView& picture);

private:
    void drawBackdrop(const Backdrop& backdrop);
    void setMove(QOpenGLShaderProgram& to) const;
    void drawMesh(const OrbitCamera& camera, const MeshView& picture);
    void drawWires(const OrbitCamera& camera, const MeshView& picture);

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_meshProgram, m_wireProgram, m_backdropProgram;
    unsigned int m_noVertices = 0;
    Cut m_cut;
    QVector4D m_ball, m_ballImage; ///< tinted ball and its mirror image: centre (xyz) and radius (w), mm
    float m_ballFalloff = 0, m_ballCore = 0, m_sectors = 1;
    std::optional<core::TransformUniforms> m_move;
    MeshBuffer m_mesh;
};
} // namespace ui
