#include "ui/scene/scene.h"

#include "ui/scene/ghost_renderer.h"
#include "ui/scene/overlay_entities.h"
#include "ui/scene/qt3d_engine.h"
#include "ui/scene/reference_renderer.h"
#include "ui/scene/render_target.h"

#include "core/stroke/symmetry_plane.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVersionFunctionsFactory>

namespace ui
{
namespace
{
class SceneText
{
    Q_DECLARE_TR_FUNCTIONS(ui::Scene)
};

constexpr int samplesPerPixel = 4;
const QColor markColor(255, 70, 200); ///< a hue that no scale of shades has

double milliseconds(const QElapsedTimer& since)
{
    return static_cast<double>(since.nsecsElapsed()) * 1e-6;
}

QOpenGLFunctions_3_3_Core* functionsOf(QOpenGLContext* context)
{
    return QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context);
}
} // namespace

struct Scene::State
{
    QOffscreenSurface surface;                  ///< outlives the engine and the contexts
    std::unique_ptr<QOpenGLContext> ownContext; ///< used in Layered mode only
    std::unique_ptr<Qt3dEngine> engine;
    Ground* ground = nullptr;                       ///< owned by the engine's root
    BrushCursor *cursor = nullptr, *mark = nullptr; ///< owned by the engine's root
    SymmetryPlane* plane = nullptr;                 ///< owned by the engine's root
    SectorBorders* borders = nullptr;               ///< owned by the engine's root
    Mode mode = Mode::InQt3dContext;
    QOpenGLContext* context = nullptr; ///< the context that has the clay's buffers and the target
    QOpenGLFunctions_3_3_Core* gl = nullptr;
    RenderTarget target;
    MeshRenderer painter;
    ReferenceRenderer referenceRenderer;
    PlacedReference reference;
    GhostRenderer ghosts;
    std::unique_ptr<QOpenGLShaderProgram> layerProgram;
    unsigned int noVertices = 0;
    MeshView picture;
    std::shared_ptr<const core::Footprint> footprint; ///< footprint that is tinted at present
    std::shared_ptr<const core::Footprint> shades;
    bool hasModel = false, wantsGround = true;
    bool usable = false;

    void startEngine(Qt3dEngine::Target target);
    bool startInQt3dContext();
    bool startLayered();
    bool createResources();
    void warmUp();
    void makeCurrent() { context->makeCurrent(&surface); }
    void showGround();
    void drawOverlay();
    void drawOverlay(unsigned int texture);
};

void Scene::State::startEngine(Qt3dEngine::Target wanted)
{
    engine = std::make_unique<Qt3dEngine>(&surface, wanted);
    ground = new Ground(engine->root());
    ground->setEnabled(false);
    cursor = new BrushCursor(engine->root());
    cursor->setEnabled(false);
    mark = new BrushCursor(engine->root());
    mark->setColor(markColor);
    mark->setEnabled(false);
    plane = new SymmetryPlane(engine->root());
    plane->setEnabled(false);
    borders = new SectorBorders(engine->root());
    borders->setEnabled(false);
    engine->start();
}

bool Scene::State::startInQt3dContext()
{
    startEngine(Qt3dEngine::Target::BoundFramebuffer);
    context = engine->context();
    if (!context || !(gl = functionsOf(context)) || !createResources())
        return false;
    RenderTarget test; // not multisampled, because it is read back
    test.create(gl, 0);
    const bool works = test.resize({16, 16}) && (test.bind(), engine->drawsIntoBoundFramebuffer(test.framebuffer()));
    test.destroy();
    return works;
}

bool Scene::State::startLayered()
{
    if (gl) {
        painter.destroy();
        referenceRenderer.destroy();
        ghosts.destroy();
        target.destroy();
    }
    engine.reset();
    mode = Mode::Layered;
    startEngine(Qt3dEngine::Target::OwnTexture);
    ownContext = std::make_unique<QOpenGLContext>();
    ownContext->setFormat(surface.requestedFormat());
    ownContext->setShareContext(QOpenGLContext::globalShareContext());
    if (!ownContext->create() || !ownContext->makeCurrent(&surface))
        return false;
    context = ownContext.get();
    gl = functionsOf(context);
    if (!gl || !createResources())
        return false;
    layerProgram = std::make_unique<QOpenGLShaderProgram>();
    gl->glGenVertexArrays(1, &noVertices);
    return layerProgram->addShaderFromSourceFile(QOpenGLShader::Vertex, QStringLiteral(":/shaders/background.vert")) &&
           layerProgram->addShaderFromSourceFile(QOpenGLShader::Fragment, QStringLiteral(":/shaders/layer.frag")) &&
           layerProgram->link();
}

bool Scene::State::createResources()
{
    target.create(gl, samplesPerPixel);
    return painter.create(gl) && referenceRenderer.create(gl) && ghosts.create(gl);
}

/// Draws Qt3D's entities over clay and backdrop. Qt3D restores most of the OpenGL state that others left behind, but
/// not the state set here.
void Scene::State::drawOverlay()
{
    if (mode == Mode::InQt3dContext) {
        gl->glCullFace(GL_BACK);
        gl->glFrontFace(GL_CCW);
        gl->glDisable(GL_FRAMEBUFFER_SRGB);
        gl->glDisable(GL_RASTERIZER_DISCARD);
        gl->glEnable(GL_DEPTH_TEST);
        engine->frame();
    } else if (cursor->isEnabled() || mark->isEnabled()) {
        engine->frame();
        makeCurrent();
        target.bind();
        drawOverlay(engine->texture());
    }
}

void Scene::State::drawOverlay(unsigned int texture)
{
    if (!texture)
        return;
    gl->glDisable(GL_DEPTH_TEST);
    gl->glEnable(GL_BLEND);
    gl->glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->glActiveTexture(GL_TEXTURE0);
    gl->glBindTexture(GL_TEXTURE_2D, texture);
    layerProgram->bind();
    gl->glBindVertexArray(noVertices);
    gl->glDrawArrays(GL_TRIANGLES, 0, 3);
    gl->glBindVertexArray(0);
    layerProgram->release();
    gl->glBindTexture(GL_TEXTURE_2D, 0);
    gl->glDisable(GL_BLEND);
}

/// Shows the ground if there is a model and it is wanted. Layered mode has neither ground, symmetry plane nor sector
/// borders, because their depth could not be compared with the clay's.
void Scene::State::showGround()
{
    ground->setEnabled(hasModel && wantsGround && mode == Mode::InQt3dContext);
}

/// Draws every entity once, offscreen. Otherwise ground and cursor would be missing in the first frames.
void Scene::State::warmUp()
{
    ground->setEnabled(mode == Mode::InQt3dContext);
    plane->setEnabled(mode == Mode::InQt3dContext);
    borders->setEnabled(mode == Mode::InQt3dContext);
    cursor->setEnabled(true);
    mark->setEnabled(true);
    for (int i = 0; i < Qt3dEngine::warmUpFrames; ++i) {
        makeCurrent();
        target.resize({16, 16});
        target.bind();
        drawOverlay();
    }
    cursor->setEnabled(false);
    mark->setEnabled(false);
    plane->setEnabled(false);
    borders->setEnabled(false);
    ground->setEnabled(false); // hidden until there is a model
}

Scene::Scene(Mode wanted) : m_state(std::make_unique<State>())
{
    m_state->surface.setFormat(QSurfaceFormat::defaultFormat());
    m_state->surface.create();
    m_state->usable = (wanted == Mode::InQt3dContext && m_state->startInQt3dContext()) || m_state->startLayered();
    setAppearance({}, false);
    if (m_state->usable)
        m_state->warmUp();
}

Scene::~Scene()
{
    if (m_state->context && m_state->context->makeCurrent(&m_state->surface)) {
        m_state->layerProgram.reset();
        m_state->painter.destroy();
        m_state->referenceRenderer.destroy();
        m_state->ghosts.destroy();
        m_state->target.destroy();
        m_state->context->doneCurrent();
    }
    m_state->engine.reset();
}

bool Scene::usable() const
{
    return m_state->usable;
}

Scene::Mode Scene::mode() const
{
    return m_state->mode;
}

MeshBuffer& Scene::meshBuffer()
{
    m_state->makeCurrent();
    return m_state->painter.meshBuffer();
}

void Scene::placeGround(const core::Box& box)
{
    m_state->ground->place(box);
    m_state->hasModel = true;
    m_state->showGround();
}

void Scene::placeCursor(const core::SurfaceHit& hit, double radius, const QColor& color)
{
    m_state->cursor->place(hit.position, hit.normal, radius);
    m_state->cursor->setColor(color);
    m_state->cursor->setEnabled(true);
}

void Scene::hideCursor()
{
    m_state->cursor->setEnabled(false);
}

void Scene::tintBall(const core::Vec3& center, const core::StrokeSettings& brush)
{
    tint(nullptr);
    m_state->painter.tintBall(center, brush);
}

void Scene::tint(const std::shared_ptr<const core::Footprint>& footprint)
{
    m_state->painter.tintNothing();
    if (footprint == m_state->footprint)
        return;
    m_state->footprint = footprint;
    meshBuffer().tint(footprint.get());
}

void Scene::move(const std::shared_ptr<const core::Footprint>& vertices, const core::Transform& by)
{
    if (vertices)
        tint(vertices);
    m_state->painter.move(vertices ? std::optional(core::uniformsOf(by)) : std::nullopt);
}

void Scene::shade(const std::shared_ptr<const core::Footprint>& shades)
{
    if (shades == m_state->shades)
        return;
    m_state->shades = shades;
    meshBuffer().shade(shades.get());
}

void Scene::showMark(const core::Vec3& point, const core::Vec3& normal, double radius)
{
    m_state->mark->place(point, normal, radius);
    m_state->mark->setEnabled(true);
}

void Scene::hideMark()
{
    m_state->mark->setEnabled(false);
}

void Scene::showPlane(core::Symmetry symmetry, const core::Box& box)
{
    const bool shown = symmetry != core::Symmetry::None && !box.isEmpty();
    m_state->painter.setCut({shown ? core::planeNormal(symmetry) : core::Vec3::Zero()});
    if (shown)
        m_state->plane->place(symmetry, box);
    m_state->plane->setEnabled(shown && m_state->mode == Mode::InQt3dContext);
}

void Scene::showCut(const core::Vec3& point, const core::Vec3& normal, core::Symmetry image)
{
    m_state->painter.setCut({normal, point, true, image});
    m_state->plane->setEnabled(false);
}

void Scene::showSectors(int sectors, core::Symmetry symmetry, const core::Box& box)
{
    const bool shown = sectors > 1 && !box.isEmpty();
    if (shown)
        m_state->borders->place(sectors, symmetry, box);
    m_state->borders->setEnabled(shown && m_state->mode == Mode::InQt3dContext);
}

void Scene::showReference(const PlacedReference& reference)
{
    m_state->reference = reference;
}

void Scene::showAvatar(const std::optional<HeadsetAvatar>& avatar)
{
    m_state->ghosts.show(avatar);
}

void Scene::showTeacher(const std::optional<core::Sphere>& brush)
{
    m_state->ghosts.showTeacher(brush);
}

void Scene::showGlass(const std::shared_ptr<const core::DrawArrays>& glass)
{
    m_state->ghosts.showGlass(glass);
}

void Scene::setAppearance(const ViewAppearance& appearance, bool darkTheme)
{
    State& s = *m_state;
    s.picture.backdrop = backdropOf(appearance.background, darkTheme);
    s.picture.shading = shadingOf(appearance.material);
    s.picture.flat = appearance.flat;
    s.picture.tint = appearance.tint;
    s.picture.cavity = appearance.cavity;
    s.picture.wireframe = appearance.wireframe;
    s.ground->setDark(isDark(s.picture.backdrop));
    s.plane->setDark(isDark(s.picture.backdrop));
    s.borders->setDark(isDark(s.picture.backdrop));
    s.ghosts.setDark(isDark(s.picture.backdrop));
    s.wantsGround = appearance.ground;
    s.showGround();
}

Scene::Image Scene::render(const OrbitCamera& camera, QSize pixels, double pixelRatio)
{
    State& s = *m_state;
    Image image;
    QElapsedTimer timer;
    s.engine->setView(camera, pixels);
    s.cursor->setPixels(pixels, pixelRatio);
    s.mark->setPixels(pixels, pixelRatio);
    s.plane->setPixelRatio(pixelRatio);
    s.borders->setPixelRatio(pixelRatio);
    s.makeCurrent();
    if (!s.target.resize(pixels))
        return image;

    timer.start();
    s.target.bind();
    s.picture.pixels = pixels;
    s.picture.pixelRatio = pixelRatio;
    s.painter.draw(camera, s.picture);
    image.isDraft = s.referenceRenderer.draw(camera, s.reference);
    image.drawMs = milliseconds(timer);
    timer.start();
    s.drawOverlay();
    s.ghosts.draw(camera);
    image.sceneMs = milliseconds(timer);
    s.target.resolve();

    image.texture = s.target.texture();
    image.ready = s.gl->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    s.gl->glFlush();
    return image;
}

QString graphicsProblem()
{
    static const QString problem = [] {
        if (!QOpenGLContext::globalShareContext())
            return SceneText::tr("The model cannot be shown: this display offers no OpenGL.");
        QOffscreenSurface surface;
        surface.setFormat(QSurfaceFormat::defaultFormat());
        surface.create();
        QOpenGLContext context;
        context.setFormat(QSurfaceFormat::defaultFormat());
        if (!context.create() || !context.makeCurrent(&surface))
            return SceneText::tr("The model cannot be shown: OpenGL does not start on this display.");
        const auto version = context.format().version();
        if (version < qMakePair(3, 3) || !functionsOf(&context))
            return SceneText::tr("The model cannot be shown: OpenGL 3.3 is needed, and this display offers %1.%2.")
                .arg(version.first)
                .arg(version.second);
        return QString();
    }();
    return problem;
}
} // namespace ui
