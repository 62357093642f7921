#include "ui/scene/gl_overlays.h"

#include "ui/scene/gl_convert.h"

#include <QOffscreenSurface>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVersionFunctionsFactory>

namespace ui
{
namespace
{
QString shaderFile(const QString& name, const char* suffix)
{
    return QStringLiteral(":/shaders/%1.%2").arg(name, QLatin1StringView(suffix));
}

void setUniforms(QOpenGLShaderProgram& program, const std::vector<Overlay::Uniform>& uniforms)
{
    for (const Overlay::Uniform& uniform : uniforms)
        std::visit([&](const auto& value) { program.setUniformValue(uniform.name, value); }, uniform.value);
}

/// Matrices and vectors of a view, by the names that Qt3D gives them.
struct View
{
    QMatrix4x4 view, projection;
    QVector3D eye;

    explicit View(const OrbitCamera& camera)
        : view(toQt(camera.viewMatrix()))
        , projection(toQt(camera.projectionMatrix()))
        , eye(view.inverted().column(3).toVector3D())
    {}
};

class GlOverlays : public OverlayRenderer
{
public:
    explicit GlOverlays(QOffscreenSurface& surface) : m_surface(surface) {}
    ~GlOverlays() override;

    /// Returns false if the driver gives no context, or a shader does not compile.
    bool create(const std::vector<const Overlay*>& overlays);

    QOpenGLContext* context() const override { return m_context.get(); }
    void draw(const OrbitCamera& camera, QSize pixels) override;

private:
    /// The vertices and the program of an overlay.
    struct Drawn
    {
        const Overlay* overlay = nullptr;
        std::unique_ptr<QOpenGLShaderProgram> program;
        unsigned int vertexArray = 0, buffer = 0;
        int vertexCount = 0;
    };

    bool upload(Drawn& drawn);
    void draw(const Drawn& drawn, const View& view);

    QOffscreenSurface& m_surface;
    const std::unique_ptr<QOpenGLContext> m_context = std::make_unique<QOpenGLContext>();
    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::vector<Drawn> m_drawn;
};

GlOverlays::~GlOverlays()
{
    if (m_drawn.empty() || !m_context->makeCurrent(&m_surface))
        return;
    for (Drawn& drawn : m_drawn) {
        drawn.program.reset();
        m_gl->glDeleteVertexArrays(1, &drawn.vertexArray);
        m_gl->glDeleteBuffers(1, &drawn.buffer);
    }
    m_context->doneCurrent();
}

bool GlOverlays::create(const std::vector<const Overlay*>& overlays)
{
    m_context->setFormat(m_surface.requestedFormat());
    m_context->setShareContext(QOpenGLContext::globalShareContext());
    if (!m_context->create() || !m_context->makeCurrent(&m_surface))
        return false;
    m_gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(m_context.get());
    if (!m_gl)
        return false;
    for (const Overlay* overlay : overlays) {
        m_drawn.push_back({overlay, std::make_unique<QOpenGLShaderProgram>()});
        if (!upload(m_drawn.back()))
            return false;
    }
    return true;
}

bool GlOverlays::upload(Drawn& drawn)
{
    const Overlay::Shape& shape = drawn.overlay->shape();
    QOpenGLShaderProgram& program = *drawn.program;
    if (!program.addShaderFromSourceFile(QOpenGLShader::Vertex, shaderFile(shape.vertexShader, "vert")) ||
        !program.addShaderFromSourceFile(QOpenGLShader::Fragment, shaderFile(shape.fragmentShader, "frag")) ||
        !program.link())
        return false;
    int perVertex = 0;
    for (const Overlay::Attribute& attribute : shape.attributes)
        perVertex += attribute.floats;
    drawn.vertexCount = static_cast<int>(shape.vertices.size()) / perVertex;
    m_gl->glGenVertexArrays(1, &drawn.vertexArray);
    m_gl->glBindVertexArray(drawn.vertexArray);
    m_gl->glGenBuffers(1, &drawn.buffer);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, drawn.buffer);
    m_gl->glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.vertices.size() * sizeof(float)),
                       shape.vertices.data(), GL_STATIC_DRAW);
    int offset = 0;
    for (const Overlay::Attribute& attribute : shape.attributes) {
        program.enableAttributeArray(attribute.name);
        program.setAttributeBuffer(attribute.name, GL_FLOAT, offset * static_cast<int>(sizeof(float)), attribute.floats,
                                   perVertex * static_cast<int>(sizeof(float)));
        offset += attribute.floats;
    }
    m_gl->glBindVertexArray(0);
    m_gl->glBindBuffer(GL_ARRAY_BUFFER, 0);
    return true;
}

void GlOverlays::draw(const OrbitCamera& camera, QSize)
{
    const View view(camera);
    m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glDepthMask(GL_FALSE);
    m_gl->glDisable(GL_CULL_FACE);
    m_gl->glEnable(GL_BLEND);
    m_gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const Drawn& drawn : m_drawn)
        if (drawn.overlay->isShown())
            draw(drawn, view);
    m_gl->glBindVertexArray(0);
    m_gl->glDisable(GL_BLEND);
    m_gl->glBlendFunc(GL_ONE, GL_ZERO);
    m_gl->glDepthFunc(GL_LESS);
    m_gl->glDepthMask(GL_TRUE);
}

void GlOverlays::draw(const Drawn& drawn, const View& view)
{
    const QMatrix4x4& model = drawn.overlay->modelMatrix();
    QOpenGLShaderProgram& program = *drawn.program;
    program.bind();
    program.setUniformValue("modelMatrix", model);
    program.setUniformValue("viewMatrix", view.view);
    program.setUniformValue("projectionMatrix", view.projection);
    program.setUniformValue("eyePosition", view.eye);
    program.setUniformValue("mvp", view.projection * view.view * model);
    setUniforms(program, drawn.overlay->uniforms());
    m_gl->glBindVertexArray(drawn.vertexArray);
    for (const Overlay::Pass& pass : drawn.overlay->shape().passes) {
        m_gl->glDepthFunc(pass.depth == Overlay::Depth::InFront ? GL_LEQUAL : GL_GREATER);
        setUniforms(program, pass.uniforms);
        m_gl->glDrawArrays(GL_TRIANGLES, 0, drawn.vertexCount);
    }
    program.release();
}
} // namespace

std::unique_ptr<OverlayRenderer> makeGlOverlays(QOffscreenSurface& surface, const std::vector<const Overlay*>& overlays)
{
    auto made = std::make_unique<GlOverlays>(surface);
    return made->create(overlays) ? std::move(made) : nullptr;
}
} // namespace ui
