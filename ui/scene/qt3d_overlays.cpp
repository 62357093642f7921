#include "ui/scene/qt3d_overlays.h"

#include "ui/scene/qt3d_engine.h"
#include "ui/scene/render_target.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>
#include <QUrl>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

namespace ui
{
namespace
{
using Qt3DRender::QParameter;

QVariant variantOf(const Overlay::Value& value)
{
    return std::visit([](const auto& of) { return QVariant::fromValue(of); }, value);
}

QParameter* parameterOf(const Overlay::Uniform& uniform)
{
    return new QParameter(QLatin1StringView(uniform.name), variantOf(uniform.value));
}

Qt3DRender::QGeometryRenderer* geometryOf(const Overlay::Shape& shape)
{
    unsigned int perVertex = 0;
    for (const Overlay::Attribute& attribute : shape.attributes)
        perVertex += static_cast<unsigned int>(attribute.floats);
    auto* geometry = new Qt3DCore::QGeometry;
    auto* buffer = new Qt3DCore::QBuffer(geometry);
    buffer->setData(QByteArray(reinterpret_cast<const char*>(shape.vertices.data()),
                               static_cast<qsizetype>(shape.vertices.size() * sizeof(float))));
    constexpr auto bytes = static_cast<unsigned int>(sizeof(float));
    const auto count = static_cast<unsigned int>(shape.vertices.size()) / perVertex;
    unsigned int offset = 0;
    for (const Overlay::Attribute& attribute : shape.attributes) {
        const auto floats = static_cast<unsigned int>(attribute.floats);
        geometry->addAttribute(new Qt3DCore::QAttribute(buffer, QLatin1StringView(attribute.name),
                                                        Qt3DCore::QAttribute::Float, floats, count, offset * bytes,
                                                        perVertex * bytes));
        offset += floats;
    }
    auto* renderer = new Qt3DRender::QGeometryRenderer;
    renderer->setGeometry(geometry);
    renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
    return renderer;
}

Qt3DRender::QRenderPass* passOf(const Overlay::Pass& pass, Qt3DRender::QShaderProgram* program)
{
    using Arguments = Qt3DRender::QBlendEquationArguments;
    auto* made = new Qt3DRender::QRenderPass;
    made->setShaderProgram(program);
    auto* test = new Qt3DRender::QDepthTest;
    test->setDepthFunction(pass.depth == Overlay::Depth::InFront ? Qt3DRender::QDepthTest::LessOrEqual
                                                                 : Qt3DRender::QDepthTest::Greater);
    auto* factors = new Arguments;
    factors->setSourceRgb(Arguments::SourceAlpha);
    factors->setDestinationRgb(Arguments::OneMinusSourceAlpha);
    factors->setSourceAlpha(Arguments::One);
    factors->setDestinationAlpha(Arguments::OneMinusSourceAlpha);
    auto* equation = new Qt3DRender::QBlendEquation;
    equation->setBlendFunction(Qt3DRender::QBlendEquation::Add);
    auto* cull = new Qt3DRender::QCullFace;
    cull->setMode(Qt3DRender::QCullFace::NoCulling);
    for (Qt3DRender::QRenderState* state :
         std::initializer_list<Qt3DRender::QRenderState*>{test, factors, equation, cull, new Qt3DRender::QNoDepthMask})
        made->addRenderState(state);
    for (const Overlay::Uniform& uniform : pass.uniforms)
        made->addParameter(parameterOf(uniform));
    return made;
}

Qt3DRender::QShaderProgram* programOf(const Overlay::Shape& shape)
{
    auto* made = new Qt3DRender::QShaderProgram;
    const QString url = QStringLiteral("qrc:/shaders/%1.%2");
    const auto source = [&](const QString& name, const QString& suffix) {
        return Qt3DRender::QShaderProgram::loadSource(QUrl(url.arg(name, suffix)));
    };
    made->setVertexShaderCode(source(shape.vertexShader, QStringLiteral("vert")));
    made->setFragmentShaderCode(source(shape.fragmentShader, QStringLiteral("frag")));
    return made;
}

Qt3DRender::QMaterial* materialOf(const Overlay::Shape& shape)
{
    auto* technique = new Qt3DRender::QTechnique;
    technique->graphicsApiFilter()->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
    technique->graphicsApiFilter()->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
    technique->graphicsApiFilter()->setMajorVersion(3);
    technique->graphicsApiFilter()->setMinorVersion(3);
    Qt3DRender::QShaderProgram* program = programOf(shape);
    for (const Overlay::Pass& pass : shape.passes)
        technique->addRenderPass(passOf(pass, program));
    auto* effect = new Qt3DRender::QEffect;
    effect->addTechnique(technique);
    auto* made = new Qt3DRender::QMaterial;
    made->setEffect(effect);
    return made;
}

/// An overlay as an entity, which follows it.
class OverlayEntity
{
public:
    /// The parent owns the entity.
    OverlayEntity(const Overlay& overlay, Qt3DCore::QNode* parent)
        : m_overlay(overlay)
        , m_entity(new Qt3DCore::QEntity(parent))
        , m_transform(new Qt3DCore::QTransform)
    {
        Qt3DRender::QMaterial* material = materialOf(overlay.shape());
        for (const Overlay::Uniform& uniform : overlay.uniforms()) {
            m_parameters.push_back(parameterOf(uniform));
            material->addParameter(m_parameters.back());
        }
        m_entity->addComponent(geometryOf(overlay.shape()));
        m_entity->addComponent(m_transform);
        m_entity->addComponent(material);
        m_entity->setEnabled(false);
    }

    void setEnabled(bool enabled) { m_entity->setEnabled(enabled); }
    /// Takes over what has changed.
    void update()
    {
        m_entity->setEnabled(m_overlay.isShown());
        if (!m_overlay.isShown())
            return;
        m_transform->setMatrix(m_overlay.modelMatrix());
        for (std::size_t i = 0; i < m_parameters.size(); ++i)
            m_parameters[i]->setValue(variantOf(m_overlay.uniforms()[i].value));
    }

private:
    const Overlay& m_overlay;
    Qt3DCore::QEntity* m_entity;
    Qt3DCore::QTransform* m_transform;
    std::vector<QParameter*> m_parameters;
};

class Qt3dOverlays : public OverlayRenderer
{
public:
    explicit Qt3dOverlays(QOffscreenSurface& surface) : m_engine(surface) {}

    /// Returns false if Qt3D does not draw into the bound framebuffer.
    bool create(const std::vector<const Overlay*>& overlays);

    QOpenGLContext* context() const override { return m_engine.context(); }
    void draw(const OrbitCamera& camera, QSize pixels) override;

private:
    /// Renders a frame. Qt3D restores most of the OpenGL state that others left behind, but not the state set here.
    void frame();

    Qt3dEngine m_engine;
    std::vector<OverlayEntity> m_entities;
    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
};

/// Draws every entity once, offscreen. Otherwise overlays would be missing in the first frames.
bool Qt3dOverlays::create(const std::vector<const Overlay*>& overlays)
{
    for (const Overlay* overlay : overlays)
        m_entities.emplace_back(*overlay, m_engine.root());
    m_engine.start();
    m_gl = context() ? QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context()) : nullptr;
    if (!m_gl)
        return false;
    RenderTarget test; // not multisampled, because it is read back
    test.create(m_gl, 0);
    const bool works = test.resize({16, 16}) && (test.bind(), m_engine.drawsIntoBoundFramebuffer(test.framebuffer()));
    for (OverlayEntity& entity : m_entities)
        entity.setEnabled(true);
    for (int i = 0; works && i < Qt3dEngine::warmUpFrames; ++i) {
        test.bind();
        frame();
    }
    test.destroy();
    return works;
}

void Qt3dOverlays::draw(const OrbitCamera& camera, QSize pixels)
{
    for (OverlayEntity& entity : m_entities)
        entity.update();
    m_engine.setView(camera, pixels);
    frame();
}

void Qt3dOverlays::frame()
{
    m_gl->glCullFace(GL_BACK);
    m_gl->glFrontFace(GL_CCW);
    m_gl->glDisable(GL_FRAMEBUFFER_SRGB);
    m_gl->glDisable(GL_RASTERIZER_DISCARD);
    m_gl->glEnable(GL_DEPTH_TEST);
    m_engine.frame();
}
} // namespace

std::unique_ptr<OverlayRenderer> makeQt3dOverlays(QOffscreenSurface& surface,
                                                  const std::vector<const Overlay*>& overlays)
{
    auto made = std::make_unique<Qt3dOverlays>(surface);
    return made->create(overlays) ? std::move(made) : nullptr;
}
} // namespace ui
