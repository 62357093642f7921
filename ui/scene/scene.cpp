#include "ui/scene/scene.h"

#include "ui/scene/ghost_renderer.h"
#include "ui/scene/gl_overlays.h"
#include "ui/scene/overlays.h"
#include "ui/scene/qt3d_overlays.h"
#include "ui/scene/reference_renderer.h"
#include "ui/scene/render_target.h"

#include "core/stroke/symmetry_plane.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLFunctions>
#include <QOpenGLFunctions_3_3_Core>
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

/// Returns the name that the current context's driver gives itself.
QString rendererName(QOpenGLFunctions& gl)
{
    return QString::fromUtf8(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
}

QOpenGLFunctions_3_3_Core* functionsOf(QOpenGLContext* context)
{
    return QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context);
}
} // namespace

struct Scene::State
{
    QOffscreenSurface surface; ///< outlives the context
    Ground ground;
    BrushCursor cursor, mark;
    SymmetryPlane plane;
    SectorBorders borders;
    std::unique_ptr<OverlayRenderer> overlays;
    Mode mode = Mode::Qt3d;
    QOpenGLContext* context = nullptr; ///< the context of `overlays`
    QOpenGLFunctions_3_3_Core* gl = nullptr;
    RenderTarget target;
    MeshRenderer painter;
    ReferenceRenderer referenceRenderer;
    PlacedReference reference;
    GhostRenderer ghosts;
    MeshView picture;
    std::shared_ptr<const core::Footprint> footprint; ///< footprint that is tinted at present
    std::shared_ptr<const core::Footprint> shades;
    bool hasModel = false, wantsGround = true;
    bool usable = false;

    bool start(Mode wanted);
    void makeCurrent() { context->makeCurrent(&surface); }
    void showGround() { ground.setShown(hasModel && wantsGround); }
};

bool Scene::State::start(Mode wanted)
{
    const std::vector<const Overlay*> all{&ground, &cursor, &mark, &plane, &borders};
    mode = wanted;
    if (mode == Mode::Qt3d)
        overlays = makeQt3dOverlays(surface, all);
    if (!overlays) {
        mode = Mode::OpenGl;
        overlays = makeGlOverlays(surface, all);
    }
    if (!overlays)
        return false;
    context = overlays->context();
    gl = functionsOf(context);
    target.create(gl, samplesPerPixel);
    return painter.create(gl) && referenceRenderer.create(gl) && ghosts.create(gl);
}

Scene::Scene(Mode wanted) : m_state(std::make_unique<State>())
{
    m_state->surface.setFormat(QSurfaceFormat::defaultFormat());
    m_state->surface.create();
    m_state->mark.setColor(markColor);
    m_state->usable = m_state->start(wanted);
    setAppearance({}, false);
}

Scene::~Scene()
{
    if (m_state->context && m_state->context->makeCurrent(&m_state->surface)) {
        m_state->painter.destroy();
        m_state->referenceRenderer.destroy();
        m_state->ghosts.destroy();
        m_state->target.destroy();
        m_state->context->doneCurrent();
    }
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
    m_state->ground.place(box);
    m_state->hasModel = true;
    m_state->showGround();
}

void Scene::placeCursor(const core::SurfaceHit& hit, double radius, const QColor& color)
{
    m_state->cursor.place(hit.position, hit.normal, radius);
    m_state->cursor.setColor(color);
    m_state->cursor.setShown(true);
}

void Scene::hideCursor()
{
    m_state->cursor.setShown(false);
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
    m_state->mark.place(point, normal, radius);
    m_state->mark.setShown(true);
}

void Scene::hideMark()
{
    m_state->mark.setShown(false);
}

void Scene::showPlane(core::Symmetry symmetry, const core::Box& box)
{
    const bool shown = symmetry != core::Symmetry::None && !box.isEmpty();
    m_state->painter.setCut({shown ? core::planeNormal(symmetry) : core::Vec3::Zero()});
    if (shown)
        m_state->plane.place(symmetry, box);
    m_state->plane.setShown(shown);
}

void Scene::showCut(const core::Vec3& point, const core::Vec3& normal, core::Symmetry image)
{
    m_state->painter.setCut({normal, point, true, image});
    m_state->plane.setShown(false);
}

void Scene::showSectors(int sectors, core::Symmetry symmetry, const core::Box& box)
{
    const bool shown = sectors > 1 && !box.isEmpty();
    if (shown)
        m_state->borders.place(sectors, symmetry, box);
    m_state->borders.setShown(shown);
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

void Scene::showTranslucent(const std::shared_ptr<const core::DrawArrays>& translucent)
{
    m_state->ghosts.showTranslucent(translucent);
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
    s.ground.setDark(isDark(s.picture.backdrop));
    s.plane.setDark(isDark(s.picture.backdrop));
    s.borders.setDark(isDark(s.picture.backdrop));
    s.ghosts.setDark(isDark(s.picture.backdrop));
    s.wantsGround = appearance.ground;
    s.showGround();
}

Scene::Image Scene::render(const OrbitCamera& camera, QSize pixels, double pixelRatio)
{
    State& s = *m_state;
    Image image;
    QElapsedTimer timer;
    s.cursor.setPixels(pixels, pixelRatio);
    s.mark.setPixels(pixels, pixelRatio);
    s.plane.setPixelRatio(pixelRatio);
    s.borders.setPixelRatio(pixelRatio);
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
    s.overlays->draw(camera, pixels);
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
            //: %1.%2: a version; %3: the name of the OpenGL driver
            return SceneText::tr("The model cannot be shown: OpenGL 3.3 is needed, and this display offers %1.%2 (%3). "
                                 "Update the graphics driver, or install Mesa's software driver, llvmpipe.")
                .arg(version.first)
                .arg(version.second)
                .arg(rendererName(*context.functions()));
        return QString();
    }();
    return problem;
}
} // namespace ui
