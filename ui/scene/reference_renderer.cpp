#include "ui/scene/reference_renderer.h"

#include "ui/scene/gl_convert.h"

#include <QOpenGLShaderProgram>

namespace ui
{
namespace
{
constexpr int pixelsAtOnce = 1 << 20; ///< levels with more pixels are uploaded one per call
}

ReferenceRenderer::ReferenceRenderer() = default;
ReferenceRenderer::~ReferenceRenderer() = default;

bool ReferenceRenderer::create(QOpenGLFunctions_3_3_Core* gl)
{
    m_gl = gl;
    m_gl->glGenVertexArrays(1, &m_noVertices);
    m_program = std::make_unique<QOpenGLShaderProgram>();
    return m_program->addShaderFromSourceFile(QOpenGLShader::Vertex, QStringLiteral(":/shaders/reference.vert")) &&
           m_program->addShaderFromSourceFile(QOpenGLShader::Fragment, QStringLiteral(":/shaders/reference.frag")) &&
           m_program->link();
}

void ReferenceRenderer::destroy()
{
    if (!m_gl)
        return;
    m_program.reset();
    m_gl->glDeleteVertexArrays(1, &m_noVertices);
    m_gl->glDeleteTextures(1, &m_texture);
    m_texture = 0;
    m_picture.reset();
    m_missing = 0;
    m_gl = nullptr;
}

void ReferenceRenderer::begin(const SharedReferencePicture& picture)
{
    m_gl->glDeleteTextures(1, &m_texture);
    m_gl->glGenTextures(1, &m_texture);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(picture->levels.size()) - 1);
    m_picture = picture;
    m_missing = picture->levels.size();
}

/// Uploads some missing levels, from coarse to fine. Precondition: the texture is bound.
void ReferenceRenderer::uploadSome()
{
    const auto isSmall = [](const QImage& image) { return image.width() * image.height() <= pixelsAtOnce; };
    do {
        const QImage& image = m_picture->levels[--m_missing];
        m_gl->glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(m_missing), GL_RGBA8, image.width(), image.height(), 0,
                           GL_RGBA, GL_UNSIGNED_BYTE, image.constBits());
    } while (m_missing > 0 && isSmall(m_picture->levels[m_missing - 1]));
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(m_missing));
}

bool ReferenceRenderer::draw(const OrbitCamera& camera, const PlacedReference& reference)
{
    if (!reference.picture)
        return false;
    m_gl->glActiveTexture(GL_TEXTURE0);
    if (m_picture != reference.picture)
        begin(reference.picture);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
    if (m_missing > 0)
        uploadSome();
    m_program->bind();
    m_program->setUniformValue("clip", toQt(Eigen::Matrix4d(camera.projectionMatrix() * camera.viewMatrix())));
    m_program->setUniformValue("center", toQt(reference.center));
    m_program->setUniformValue("halfRight", toQt(reference.halfRight));
    m_program->setUniformValue("halfUp", toQt(reference.halfUp));
    m_program->setUniformValue("opacity", static_cast<float>(reference.opacity));

    if (reference.inFront)
        m_gl->glDisable(GL_DEPTH_TEST);
    else
        m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glDepthFunc(GL_LEQUAL);
    m_gl->glDepthMask(GL_FALSE);
    m_gl->glEnable(GL_BLEND);
    m_gl->glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl->glBindVertexArray(m_noVertices);
    m_gl->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl->glBindVertexArray(0);
    m_gl->glDisable(GL_BLEND);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glDepthFunc(GL_LESS);
    m_gl->glEnable(GL_DEPTH_TEST);
    m_program->release();
    m_gl->glBindTexture(GL_TEXTURE_2D, 0);
    return m_missing > 0;
}
} // namespace ui
