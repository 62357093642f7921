#pragma once

#include "ui/scene/reference_image.h"

#include <QOpenGLFunctions_3_3_Core>

#include <memory>

class QOpenGLShaderProgram;

namespace ui
{
/// Draws a reference image with OpenGL 3.3 core over the contents of the bound framebuffer, without changing depths.
/// Plain OpenGL rather than Qt3D, so that only the visible image is uploaded, level by level. Thread: the OpenGL
/// context that was current at create() must be current at every call.
class ReferenceRenderer
{
public:
    ReferenceRenderer();
    ~ReferenceRenderer();

    /// Returns false if a shader does not compile; the log is in the debug output.
    bool create(QOpenGLFunctions_3_3_Core* gl);
    void destroy();

    /// Draws the picture, or nothing if it is null. Uploads it first if it differs from the last picture drawn; a large
    /// one over several calls, coarse levels first. Returns true if the next call will draw it sharper.
    bool draw(const OrbitCamera& camera, const PlacedReference& reference);

private:
    void begin(const SharedReferencePicture& picture);
    void uploadSome();

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    unsigned int m_noVertices = 0, m_texture = 0;
    SharedReferencePicture m_picture; ///< picture that m_texture contains
    std::size_t m_missing = 0;        ///< number of the picture's finest levels that are not uploaded yet
};
} // namespace ui
