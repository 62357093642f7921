#include "clay_painter.h"

#include "gl_convert.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>

namespace ui
{
namespace
{
/// Linear. Times the default vertex colour (grey 200, linear 0.58) this is the clay: sRGB 194, 150, 126.
constexpr QVector3D clayTint{0.93F, 0.527F, 0.361F};

std::unique_ptr<QOpenGLShaderProgram> program(const QString& name)
{
    auto made = std::make_unique<QOpenGLShaderProgram>();
    const QString path = QStringLiteral(":/shaders/") + name;
    const bool ok = made->addShaderFromSourceFile(QOpenGLShader::Vertex, path + QStringLiteral(".vert")) &&
                    made->addShaderFromSourceFile(QOpenGLShader::Fragment, path + QStringLiteral(".frag")) &&
                    made->link();
    return ok ? std::move(made) : nullptr;
}
} // namespace

ClayPainter::ClayPainter() = default;
ClayPainter::~ClayPainter() = default;

bool ClayPainter::create(QOpenGLFunctions_3_3_Core* gl)
{
    m_gl = gl;
    m_clayProgram = program(QStringLiteral("clay"));
    m_backdropProgram = program(QStringLiteral("background"));
    m_gl->glGenVertexArrays(1, &m_noVertices);
    m_clay.create(gl);
    return m_clayProgram && m_backdropProgram;
}

void ClayPainter::destroy()
{
    if (!m_gl)
        return;
    m_clay.destroy();
    m_clayProgram.reset();
    m_backdropProgram.reset();
    m_gl->glDeleteVertexArrays(1, &m_noVertices);
    m_gl = nullptr;
}

void ClayPainter::draw(const OrbitCamera& camera, const Backdrop& backdrop)
{
    m_gl->glDisable(GL_BLEND);
    m_gl->glDisable(GL_SCISSOR_TEST);
    m_gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glClearDepth(1.0);
    m_gl->glClear(GL_DEPTH_BUFFER_BIT);
    drawBackdrop(backdrop);
    drawClay(camera);
}

void ClayPainter::drawBackdrop(const Backdrop& backdrop)
{
    m_gl->glDisable(GL_DEPTH_TEST);
    m_backdropProgram->bind();
    m_backdropProgram->setUniformValue("topColor", toQt(backdrop.top));
    m_backdropProgram->setUniformValue("bottomColor", toQt(backdrop.bottom));
    m_gl->glBindVertexArray(m_noVertices);
    m_gl->glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl->glBindVertexArray(0);
    m_backdropProgram->release();
}

void ClayPainter::drawClay(const OrbitCamera& camera)
{
    m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glDepthFunc(GL_LESS);
    m_gl->glEnable(GL_CULL_FACE);
    m_gl->glCullFace(GL_BACK);
    m_gl->glFrontFace(GL_CCW);
    m_clayProgram->bind();
    m_clayProgram->setUniformValue("view", toQt(camera.viewMatrix()));
    m_clayProgram->setUniformValue("projection", toQt(camera.projectionMatrix()));
    m_clayProgram->setUniformValue("tint", clayTint);
    m_clayProgram->setUniformValue("encodeSrgb", 1.0F);
    m_clayProgram->setUniformValue("cutNormal", toQt(m_cutNormal));
    m_clayProgram->setUniformValue("cut", m_cutNormal.isZero() ? 0.0F : 1.0F);
    m_clay.draw();
    m_clayProgram->release();
    m_gl->glDisable(GL_CULL_FACE);
}
} // namespace ui
