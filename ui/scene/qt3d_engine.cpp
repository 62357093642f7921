#include "ui/scene/qt3d_engine.h"

#include "ui/scene/gl_convert.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>
#include <Qt3DCore/QAspectEngine>
#include <Qt3DCore/QCoreAspect>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QRenderAspect>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QViewport>

namespace ui
{
struct Qt3dEngine::State
{
    QOffscreenSurface* surface = nullptr;
    Qt3DCore::QEntityPtr root{new Qt3DCore::QEntity};
    Qt3DCore::QAspectEngine engine;
    Qt3DRender::QRenderSurfaceSelector* selector = nullptr;
    Qt3DRender::QClearBuffers* clear = nullptr;
    Qt3DRender::QCamera* camera = nullptr;
    QOpenGLContext* context = nullptr;

    void buildFrameGraph();
};

/// Builds the frame graph: surface -> whole view -> camera. A second leaf draws nothing, because a graph without a live
/// leaf stalls Qt3D. The bound framebuffer is not cleared, because it contains the clay.
void Qt3dEngine::State::buildFrameGraph()
{
    selector = new Qt3DRender::QRenderSurfaceSelector;
    selector->setSurface(surface);
    clear = new Qt3DRender::QClearBuffers(selector);
    clear->setBuffers(Qt3DRender::QClearBuffers::None);
    new Qt3DRender::QNoDraw(clear);
    auto* viewport = new Qt3DRender::QViewport;
    viewport->setParent(selector);
    viewport->setNormalizedRect({0, 0, 1, 1});
    camera = new Qt3DRender::QCamera(root.get());
    (new Qt3DRender::QCameraSelector(viewport))->setCamera(camera);

    auto* settings = new Qt3DRender::QRenderSettings(root.get());
    settings->setActiveFrameGraph(selector);
    settings->setRenderPolicy(Qt3DRender::QRenderSettings::Always);
    root->addComponent(settings);
}

Qt3dEngine::Qt3dEngine(QOffscreenSurface& surface) : m_state(std::make_unique<State>())
{
    m_state->surface = &surface;
    m_state->engine.setRunMode(Qt3DCore::QAspectEngine::Manual);
    m_state->engine.registerAspect(new Qt3DCore::QCoreAspect);
    m_state->engine.registerAspect(new Qt3DRender::QRenderAspect(Qt3DRender::QRenderAspect::Automatic));
    m_state->buildFrameGraph();
}

/// Destroys the entities before the engine, because they deregister from its scene.
Qt3dEngine::~Qt3dEngine()
{
    m_state->engine.setRootEntity({});
    m_state->root.reset();
}

Qt3DCore::QEntity* Qt3dEngine::root() const
{
    return m_state->root.get();
}

void Qt3dEngine::start()
{
    setView({}, QSize(16, 16));
    const QOpenGLContextGroup* group = QOpenGLContext::globalShareContext()->shareGroup();
    const QList<QOpenGLContext*> before = group->shares();
    m_state->engine.setRootEntity(m_state->root);
    for (QOpenGLContext* context : group->shares())
        if (!before.contains(context))
            m_state->context = context;
    if (m_state->context && !m_state->context->makeCurrent(m_state->surface))
        m_state->context = nullptr;
}

QOpenGLContext* Qt3dEngine::context() const
{
    return m_state->context;
}

bool Qt3dEngine::drawsIntoBoundFramebuffer(unsigned int framebuffer)
{
    auto* gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(m_state->context);
    if (!gl)
        return false;
    m_state->clear->setClearColor(QColor(30, 140, 250));
    m_state->clear->setBuffers(Qt3DRender::QClearBuffers::ColorBuffer);
    for (int i = 0; i < warmUpFrames; ++i) {
        gl->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl->glClearColor(0, 0, 0, 0);
        gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        frame();
    }
    GLint bound = 0;
    gl->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    const bool kept =
        QOpenGLContext::currentContext() == m_state->context && static_cast<unsigned int>(bound) == framebuffer;
    GLubyte pixel[4] = {};
    gl->glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    m_state->clear->setBuffers(Qt3DRender::QClearBuffers::None);
    return kept && pixel[0] == 30 && pixel[1] == 140 && pixel[2] == 250 && gl->glGetError() == GL_NO_ERROR;
}

void Qt3dEngine::setView(const OrbitCamera& camera, QSize pixels)
{
    // Qt 6.8 ignores changes of camera->transform().
    const QMatrix4x4 place = toQt(Eigen::Matrix4d(camera.viewMatrix().inverse()));
    const QVector3D eye = place.column(3).toVector3D();
    m_state->camera->setPosition(eye);
    m_state->camera->setViewCenter(eye - place.column(2).toVector3D());
    m_state->camera->setUpVector(place.column(1).toVector3D());
    m_state->camera->lens()->setProjectionMatrix(toQt(camera.projectionMatrix()));
    m_state->selector->setExternalRenderTargetSize(pixels);
}

void Qt3dEngine::frame()
{
    m_state->engine.processFrame();
}
} // namespace ui
