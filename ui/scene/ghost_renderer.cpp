#include "ui/scene/ghost_renderer.h"

#include "ui/scene/ghost_shapes.h"
#include "ui/scene/gl_convert.h"

#include <QOpenGLShaderProgram>

namespace ui
{
namespace
{
// Opacity of a shape where it faces the eye, and where it turns away, 0 to 1.
const QVector2D bodyAlphas(0.42F, 0.85F), brushAlphas(0.05F, 0.60F), translucentAlphas(0.14F, 0.70F);
constexpr float translucentDepthOffset = 2; // units of glPolygonOffset

Eigen::Matrix4d sized(const Eigen::Isometry3d& pose, double size)
{
    return (pose * Eigen::Scaling(size)).matrix();
}
} // namespace

GhostRenderer::GhostRenderer() = default;
GhostRenderer::~GhostRenderer() = default;

bool GhostRenderer::create(QOpenGLFunctions_3_3_Core* gl)
{
    m_gl = gl;
    m_program = std::make_unique<QOpenGLShaderProgram>();
    return m_program->addShaderFromSourceFile(QOpenGLShader::Vertex, QStringLiteral(":/shaders/ghost.vert")) &&
           m_program->addShaderFromSourceFile(QOpenGLShader::Fragment, QStringLiteral(":/shaders/ghost.frag")) &&
           m_program->link();
}

void GhostRenderer::destroy()
{
    if (!m_gl)
        return;
    m_program.reset();
    for (Shape* shape : {&m_head, &m_ball, &m_translucent, &m_hands[0], &m_hands[1]}) {
        shape->buffer.destroy();
        shape->arrays.reset();
    }
    m_gl = nullptr;
}

void GhostRenderer::upload(Shape& shape, const std::shared_ptr<const core::DrawArrays>& arrays)
{
    if (shape.arrays == arrays)
        return;
    if (!shape.arrays)
        shape.buffer.create(m_gl);
    shape.arrays = arrays;
    shape.buffer.apply(core::wholePatchOf(*arrays));
}

/// Draws only the nearest surface: first all depths, then the colours. Depth clamping keeps a person far behind the
/// model, or between it and the eye, from being cut off.
void GhostRenderer::draw(const OrbitCamera& camera)
{
    if (!m_translucentArrays && m_translucent.arrays) {
        m_translucent.buffer.destroy();
        m_translucent.arrays.reset();
    }
    if (!m_avatar && !m_teacher && !m_translucentArrays)
        return;
    m_view = camera.viewMatrix();
    m_program->bind();
    m_program->setUniformValue("projection", toQt(camera.projectionMatrix()));
    m_program->setUniformValue("color", m_isDark ? QVector3D(0.66F, 0.80F, 0.94F) : QVector3D(0.13F, 0.27F, 0.42F));
    m_program->setUniformValue("alphas", bodyAlphas);
    m_gl->glDisable(GL_SCISSOR_TEST);
    m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glEnable(GL_DEPTH_CLAMP);
    m_gl->glEnable(GL_CULL_FACE);
    m_gl->glCullFace(GL_BACK);
    m_gl->glFrontFace(GL_CCW);
    m_gl->glDepthFunc(GL_LEQUAL);

    m_gl->glDisable(GL_BLEND);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawBodies();
    m_gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_gl->glDepthMask(GL_FALSE);
    m_gl->glEnable(GL_BLEND);
    m_gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    drawBodies();
    if (m_avatar && m_avatar->brush)
        drawBrush(*m_avatar->brush);
    if (m_teacher)
        drawBrush(*m_teacher);
    if (m_translucentArrays)
        drawTranslucent();

    m_gl->glDisable(GL_BLEND);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glDepthFunc(GL_LESS);
    m_gl->glDisable(GL_CULL_FACE);
    m_gl->glDisable(GL_DEPTH_CLAMP);
    m_program->release();
}

void GhostRenderer::drawBodies()
{
    static const auto head = std::make_shared<const core::DrawArrays>(headShape());
    if (!m_avatar)
        return;
    if (m_avatar->head) {
        upload(m_head, head);
        place(m_head, sized(*m_avatar->head, m_avatar->metre));
    }
    for (std::size_t i = 0; i < m_hands.size(); ++i)
        if (const std::optional<GhostMesh>& hand = m_avatar->hands[i]; hand && hand->shape) {
            upload(m_hands[i], hand->shape);
            place(m_hands[i], sized(hand->pose, m_avatar->metre));
        }
}

void GhostRenderer::drawBrush(const core::Sphere& brush)
{
    static const auto ball = std::make_shared<const core::DrawArrays>(ballShape());
    upload(m_ball, ball);
    m_program->setUniformValue("alphas", brushAlphas);
    place(m_ball, sized(Eigen::Isometry3d(Eigen::Translation3d(brush.center)), brush.radius));
}

/// Draws both sides, so that a cutter is seen in the hollow that it has left.
void GhostRenderer::drawTranslucent()
{
    upload(m_translucent, m_translucentArrays);
    m_program->setUniformValue("alphas", translucentAlphas);
    m_gl->glDisable(GL_CULL_FACE);
    m_gl->glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl->glPolygonOffset(translucentDepthOffset, translucentDepthOffset);
    place(m_translucent, Eigen::Matrix4d::Identity());
    m_gl->glDisable(GL_POLYGON_OFFSET_FILL);
}

void GhostRenderer::place(const Shape& shape, const Eigen::Matrix4d& toDocument)
{
    m_program->setUniformValue("place", toQt(Eigen::Matrix4d(m_view * toDocument)));
    shape.buffer.draw();
}
} // namespace ui
