#pragma once

#include "ui/scene/headset_avatar.h"
#include "ui/scene/mesh_buffer.h"
#include "ui/scene/orbit_camera.h"

#include <QOpenGLFunctions_3_3_Core>

#include <memory>

class QOpenGLShaderProgram;

namespace ui
{
/// Draws the avatar of the headset's user, the brush of a lesson's teacher, and previewed solids: half transparent,
/// after everything else, into the bound framebuffer, with OpenGL 3.3 core. The clay hides them. Plain OpenGL rather
/// than Qt3D, so that moving them costs nothing. Thread: the OpenGL context that was current at create() must be
/// current at every call, except for the setters.
class GhostRenderer
{
public:
    GhostRenderer();
    ~GhostRenderer();

    /// Returns false if a shader does not compile; the log is in the debug output.
    bool create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    /// Sets the avatar for the next frames; nullopt hides it.
    void show(const std::optional<HeadsetAvatar>& avatar) { m_avatar = avatar; }
    void showTeacher(const std::optional<core::Sphere>& brush) { m_teacher = brush; }
    /// Sets solids, in mm of the document, to be drawn half transparent; null: none. Where they lie on the clay, it is
    /// drawn.
    void showTranslucent(const std::shared_ptr<const core::DrawArrays>& translucent)
    {
        m_translucentArrays = translucent;
    }
    void setDark(bool dark) { m_isDark = dark; }
    /// Draws what is set. Uploads shapes that have not been drawn before.
    void draw(const OrbitCamera& camera);

private:
    struct Shape
    {
        std::shared_ptr<const core::DrawArrays> arrays;
        MeshBuffer buffer;
    };

    void upload(Shape& shape, const std::shared_ptr<const core::DrawArrays>& arrays);
    void drawBodies();
    void drawBrush(const core::Sphere& brush);
    void drawTranslucent();
    void place(const Shape& shape, const Eigen::Matrix4d& toDocument);

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    Shape m_head, m_ball, m_translucent;
    std::array<Shape, 2> m_hands;
    std::optional<HeadsetAvatar> m_avatar;
    std::optional<core::Sphere> m_teacher;
    std::shared_ptr<const core::DrawArrays> m_translucentArrays;
    Eigen::Matrix4d m_view = Eigen::Matrix4d::Identity(); ///< view matrix of the frame that is being drawn
    bool m_isDark = false;
};
} // namespace ui
