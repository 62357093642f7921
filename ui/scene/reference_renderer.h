#pragma once

#include "ui/scene/reference_image.h"

#include <QOpenGLFunctions_3_3_Core>

#include <memory>

class QOpenGLShaderProgram;

namespace ui
{
/// Draws a reference image with OpenGL 3.3 core into the framebuffer that is bound, over what is there, and leaves the
/// depths as they are. Plain OpenGL and not Qt3D, so that it is there in layers, too, and none is uploaded but what is
/// seen. The context that was current at create() must be current at every call.
class ReferenceRenderer
{
public:
    ReferenceRenderer();
    ~ReferenceRenderer();

    /// False if a shader does not compile; the log is in the debug output.
    bool create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    /// Uploads the picture if it is not the last one that was drawn, a large one over some calls: true while the next
    /// will draw it sharper. A null picture is nothing.
    bool draw(const OrbitCamera& camera, const PlacedReference& reference);

private:
    void begin(const SharedReferencePicture& picture);
    void uploadSome();

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    unsigned int m_noVertices = 0, m_texture = 0;
    SharedReferencePicture m_picture; ///< that the texture is of
    std::size_t m_missing = 0;        ///< so many of its finest levels are not uploaded yet
};
} // namespace ui
