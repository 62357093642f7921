#include "ui/scene/mesh_renderer.h"

#include "ui/scene/gl_convert.h"

#include "core/stroke/symmetry_plane.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QVector2D>

#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
constexpr float wireHalfWidth = 0.5F; ///< half of a wire's width, logical pixels

/// Links a shader program from files in :/shaders. The extension of a file gives its stage. Returns null on failure.
std::unique_ptr<QOpenGLShaderProgram> program(std::initializer_list<const char*> files)
{
    auto made = std::make_unique<QOpenGLShaderProgram>();
    for (const char* file : files) {
        const QString path = QStringLiteral(":/shaders/") + QLatin1StringView(file);
        const auto stage = path.endsWith(QLatin1StringView(".vert"))   ? QOpenGLShader::Vertex
                           : path.endsWith(QLatin1StringView(".geom")) ? QOpenGLShader::Geometry
                                                                       : QOpenGLShader::Fragment;
        if (!made->addShaderFromSourceFile(stage, path))
            return nullptr;
    }
    return made->link() ? std::move(made) : nullptr;
}

void setCamera(QOpenGLShaderProgram& to, const OrbitCamera& camera)
{
    to.setUniformValue("view", toQt(camera.viewMatrix()));
    to.setUniformValue("projection", toQt(camera.projectionMatrix()));
}

void setShading(QOpenGLShaderProgram& to, const core::Shading& shading)
{
    to.setUniformValue("tint", toQt(shading.tint));
    to.setUniformValue("wrap", shading.wrap);
    to.setUniformValue("gloss", shading.gloss);
    to.setUniformValue("sharpness", shading.sharpness);
    to.setUniformValue("rim", shading.rim);
    to.setUniformValue("through", toQt(shading.through));
    to.setUniformValue("sheen", toQt(shading.sheen));
}
} // namespace

MeshRenderer::MeshRenderer() = default;
MeshRenderer::~MeshRenderer() = default;

bool MeshRenderer::create(QOpenGLFunctions_3_3_Core* gl)
{
    m_gl = gl;
    m_meshProgram = program({"clay.vert", "clay.frag"});
    m_wireProgram = program({"clay.vert", "wire.geom", "wire.frag"});
    m_backdropProgram = program({"background.vert", "background.frag"});
    m_gl->glGenVertexArrays(1, &m_noVertices);
    m_mesh.create(gl);
    return m_meshProgram && m_wireProgram && m_backdropProgram;
}

void MeshRenderer::destroy()
{
    if (!m_gl)
        return;
    m_mesh.destroy();
    m_meshProgram.reset();
    m_wireProgram.reset();
    m_backdropProgram.reset();
    m_gl->glDeleteVertexArrays(1, &m_noVertices);
    m_gl = nullptr;
}

void MeshRenderer::tintBall(const core::Vec3& center, const core::StrokeSettings& brush)
{
    const core::Vec3 mirror = core::planeNormal(brush.symmetry);
    m_ball = QVector4D(toQt(center), static_cast<float>(brush.radius));
    m_ballImage = mirror.isZero() ? QVector4D()
                                  : QVector4D(toQt(core::Vec3(center - 2 * mirror * mirror.dot(center))), m_ball.w());
    m_ballFalloff = static_cast<float>(brush.falloff);
    m_ballCore = static_cast<float>(core::coreShare(brush.tool));
    m_sectors = static_cast<float>(brush.radial);
}

void MeshRenderer::tintNothing()
{
    m_ball = m_ballImage = {};
}

void MeshRenderer::draw(const OrbitCamera& camera, const MeshView& picture)
{
    m_gl->glDisable(GL_BLEND);
    m_gl->glDisable(GL_SCISSOR_TEST);
    m_gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glClearDepth(1.0);
    m_gl->glClear(GL_DEPTH_BUFFER_BIT);
    drawBackdrop(picture.backdrop);
    m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glEnable(GL_CULL_FACE);
    m_gl->glCullFace(GL_BACK);
    m_gl->glFrontFace(GL_CCW);
    drawMesh(camera, picture);
    if (picture.wireframe)
        drawWires(camera, picture);
    m_gl->glDisable(GL_CULL_FACE);
}

void MeshRenderer::drawBackdrop(const Backdrop& backdrop)
{
    m_gl->glDisable(GL_DEPTH_TEST);
    m_backdropProgram->bind();
    m_backdropProgram->setUniformValue("topColor", toQt(backdrop.top));
    m_backdropProgram->setUniformValue("bottomColor", toQt(backdrop.bottom));
    m_backdropProgram->setUniformValue("glow", backdrop.glow);
    m_gl->glBindVertexArray(m_noVertices);
    m_gl->glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl->glBindVertexArray(0);
    m_backdropProgram->release();
}

void MeshRenderer::setMove(QOpenGLShaderProgram& to) const
{
    to.setUniformValue("moved", m_move ? 1.0F : 0.0F);
    if (!m_move)
        return;
    to.setUniformValue("moveCentre", toQt(m_move->centre));
    to.setUniformValue("moveBy", toQt(m_move->by));
    to.setUniformValue("turnAxis", toQt(m_move->axis));
    to.setUniformValue("turnAngle", m_move->angle);
    const Eigen::Matrix3f rows = m_move->stretch.transpose(); // Qt reads rows
    to.setUniformValue("stretch", QMatrix3x3(rows.data()));
}

void MeshRenderer::drawMesh(const OrbitCamera& camera, const MeshView& picture)
{
    m_gl->glDepthFunc(GL_LESS);
    m_meshProgram->bind();
    setCamera(*m_meshProgram, camera);
    m_meshProgram->setUniformValue("up", toQt(core::Vec3(camera.viewMatrix().col(1).head<3>())));
    m_meshProgram->setUniformValue("lights", QMatrix3x3());
    setShading(*m_meshProgram, picture.shading);
    m_meshProgram->setUniformValue("flatShading", picture.flat);
    m_meshProgram->setUniformValue("encodeSrgb", 1.0F);
    const auto planeInEye = [&](const core::Vec3& normalInMesh, const core::Vec3& pointInMesh) {
        const core::Vec3 normal = camera.viewMatrix().topLeftCorner<3, 3>() * normalInMesh;
        const core::Vec3 point = (camera.viewMatrix() * pointInMesh.homogeneous()).head<3>();
        return QVector4D(toQt(normal), static_cast<float>(-normal.dot(point)));
    };
    const core::Vec3 mirror = core::planeNormal(m_cut.image);
    const auto image = [&](const core::Vec3& v) { return core::Vec3(v - 2 * mirror.dot(v) * mirror); };
    m_meshProgram->setUniformValue("cutPlane", planeInEye(m_cut.normal, m_cut.point));
    m_meshProgram->setUniformValue("cutImage", planeInEye(image(m_cut.normal), image(m_cut.point)));
    m_meshProgram->setUniformValue("cut", m_cut.normal.isZero() ? 0.0F : 1.0F);
    m_meshProgram->setUniformValue("cutSide", m_cut.tints ? 1.0F : 0.0F);
    m_meshProgram->setUniformValue("cutMarked", m_cut.tints ? 1.0F : 0.0F);
    m_meshProgram->setUniformValue("ball", m_ball);
    m_meshProgram->setUniformValue("ballImage", m_ballImage);
    m_meshProgram->setUniformValue("shaded", m_mesh.isShaded() ? 1.0F : 0.0F);
    m_meshProgram->setUniformValue("ballFalloff", m_ballFalloff);
    m_meshProgram->setUniformValue("ballCore", m_ballCore);
    m_meshProgram->setUniformValue("sectors", m_sectors);
    const float sector = 2 * std::numbers::pi_v<float> / m_sectors;
    m_meshProgram->setUniformValue("sector", QVector2D(std::cos(sector), std::sin(sector)));
    const QMatrix4x4 view = toQt(camera.viewMatrix());
    const auto inEye = [&](const QVector4D& ball) { return QVector4D(view.map(ball.toVector3D()), ball.w()); };
    m_meshProgram->setUniformValue("ballInEye", inEye(m_ball));
    m_meshProgram->setUniformValue("imageInEye", inEye(m_ballImage));
    m_meshProgram->setUniformValue("tinted", picture.tint && !m_cut.tints ? 1.0F : 0.0F);
    m_meshProgram->setUniformValue("cavity", picture.cavity && !m_mesh.isShaded() ? 1.0F : 0.0F);
    setMove(*m_meshProgram);
    m_mesh.draw();
    m_meshProgram->release();
}

/// Draws the triangles again, transparent except at their edges, slightly nearer to the eye than the clay.
void MeshRenderer::drawWires(const OrbitCamera& camera, const MeshView& picture)
{
    m_gl->glDepthFunc(GL_LEQUAL);
    m_gl->glDepthMask(GL_FALSE);
    m_gl->glEnable(GL_BLEND);
    m_gl->glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    m_gl->glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl->glPolygonOffset(-1, -1);
    m_wireProgram->bind();
    setCamera(*m_wireProgram, camera);
    m_wireProgram->setUniformValue("viewport", QSizeF(picture.pixels));
    m_wireProgram->setUniformValue("halfWidth", static_cast<float>(wireHalfWidth * picture.pixelRatio));
    setMove(*m_wireProgram);
    m_mesh.draw();
    m_wireProgram->release();
    m_gl->glDisable(GL_POLYGON_OFFSET_FILL);
    m_gl->glDisable(GL_BLEND);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glDepthFunc(GL_LESS);
}
} // namespace ui
