#include "ui/viewport/viewport.h"

#include "ui/scene/cursor_color.h"
#include "ui/viewport/viewport_state.h"
#include "ui/widgets/themed_icon.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QOpenGLExtraFunctions>

#include <chrono>
#include <utility>

namespace ui
{
namespace
{
double milliseconds(const QElapsedTimer& since)
{
    return static_cast<double>(since.nsecsElapsed()) * 1e-6;
}

std::int64_t steadyNow()
{
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Its tip is what picks.
QCursor pickCursor()
{
    constexpr int size = 24, tip = 3;
    return QCursor(themedIcon(QStringLiteral("pick")).pixmap(size, size), tip, size - tip);
}
} // namespace

void prepareGraphics()
{
    qputenv("QT3D_RENDERER", "opengl");
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
}

bool Viewport::State::applyPatch()
{
    if (!patchPending || !patchSource)
        return false;
    QElapsedTimer timer;
    timer.start();
    patchPending = false;
    const std::optional<core::MeshPatch> patch = patchSource();
    if (!patch || patch->empty())
        return false;
    MeshBuffer& meshBuffer = scene->meshBuffer();
    meshBuffer.apply(*patch);

    ++stats.patches;
    stats.uploadedBytes = meshBuffer.counters().bytes;
    stats.wholeUploads = meshBuffer.counters().wholeUploads;
    stats.patchMs = milliseconds(timer);
    if (patch->sampledNs != 0) {
        stats.latencyMs = static_cast<double>(steadyNow() - patch->sampledNs) * 1e-6;
        stats.worstLatencyMs = std::max(stats.worstLatencyMs, stats.latencyMs);
    }
    return true;
}

void Viewport::State::placeCursor()
{
    const std::optional<core::SurfaceHit> hit = input.hover();
    if (hit)
        scene->placeCursor(*hit, brush->value(core::Parameter::Radius), cursorColor(input.stroke()));
    else
        scene->hideCursor();
    const core::StrokeSettings settings = brush->stroke();
    if (hit && input.wouldStroke() && settings.brush == core::BrushShape::Sphere)
        scene->tintBall(hit->position, settings);
    else
        scene->tint(input.footprint());
}

void Viewport::State::updateStabilizerLine()
{
    const auto stabilizer = input.stabilizer();
    stabilizerLine->setLine(stabilizer ? QLineF(stabilizer->pointer.x(), stabilizer->pointer.y(), stabilizer->brush.x(),
                                                stabilizer->brush.y())
                                       : QLineF());
}

/// The widget's context is current.
void Viewport::State::show(const Scene::Image& image, QSize pixels, unsigned int widgetFramebuffer)
{
    QOpenGLExtraFunctions* gl = QOpenGLContext::currentContext()->extraFunctions();
    const auto ready = static_cast<GLsync>(image.ready);
    gl->glWaitSync(ready, 0, GL_TIMEOUT_IGNORED);
    gl->glDeleteSync(ready);
    if (!readFramebuffer)
        gl->glGenFramebuffers(1, &readFramebuffer);
    const int w = pixels.width(), h = pixels.height();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, readFramebuffer);
    gl->glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.texture, 0);
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, widgetFramebuffer);
    gl->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, widgetFramebuffer);
}

Viewport::Viewport(BrushSettings* brush, QWidget* parent)
    : QOpenGLWidget(parent)
    , m_state(std::make_unique<State>(brush))
{
    // Curves need every mouse move. Not earlier: Qt's X11 platform switches compression on while QApplication is made.
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    setMouseTracking(true);
    setTabletTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    setAccessibleName(tr("Model"));
    m_state->scaleBar = new ScaleBar(this);
    m_state->stabilizerLine = new StabilizerLine(this);
    m_state->highlight = new PointerHighlight(this);
    prepareFlight();
    prepareFollowing();
    prepareKeyboardCursor();
    preparePointing();

    PointerInput* input = &m_state->input;
    connect(input, &PointerInput::hoverRequested, this, &Viewport::hoverRequested);
    connect(input, &PointerInput::strokeBegan, this, &Viewport::strokeBegan);
    connect(input, &PointerInput::strokeSampled, this, &Viewport::strokeSampled);
    connect(input, &PointerInput::strokeEnded, this, &Viewport::strokeEnded);
    connect(input, &PointerInput::pressDecided, this, &Viewport::pressDecided);
    connect(input, &PointerInput::addingChanged, this, &Viewport::addingChanged);
    connect(input, &PointerInput::sphereRequested, this, &Viewport::sphereRequested);
    connect(input, &PointerInput::viewChanged, this, &Viewport::viewChanged);
    connect(this, &Viewport::viewChanged, this, qOverload<>(&Viewport::update));
    connect(input, &PointerInput::hoverChanged, this, [this] {
        updateCursor();
        m_state->updateStabilizerLine();
        update();
    });
    connect(input, &PointerInput::pickingChanged, this, &Viewport::pickingChanged);
    connect(input, &PointerInput::picked, this, [this](const std::optional<core::SurfaceHit>& hit) {
        Q_EMIT picked(hit ? std::optional(hit->color) : std::nullopt);
    });
    connect(brush, &BrushSettings::changed, this, qOverload<>(&Viewport::update));
    connect(brush, &BrushSettings::changed, input, &PointerInput::brushChanged);
    QCoreApplication::instance()->installEventFilter(this);
}

Viewport::~Viewport()
{
    if (m_state->readFramebuffer) {
        makeCurrent();
        context()->functions()->glDeleteFramebuffers(1, &m_state->readFramebuffer);
        doneCurrent();
    }
}

void Viewport::setPatchSource(std::function<std::optional<core::MeshPatch>()> patchSource)
{
    m_state->patchSource = std::move(patchSource);
    patchReady();
}

void Viewport::patchReady()
{
    m_state->patchPending = true;
    update();
}

void Viewport::showModel(const core::Box& box)
{
    finish();
    m_state->box = box;
    if (m_state->scene && m_state->scene->usable())
        m_state->scene->placeGround(box);
    m_state->input.clearHover();
    m_state->shades.reset();
    clearMark();
    m_state->camera.setPivot({});
    m_state->camera.frame(box);
    m_state->input.viewMoved();
}

void Viewport::setBox(const core::Box& box)
{
    m_state->box = box;
    m_state->camera.setScene(box);
    if (m_state->scene && m_state->scene->usable() && !box.isEmpty())
        m_state->scene->placeGround(box);
}

const core::Box& Viewport::box() const
{
    return m_state->box;
}

void Viewport::frame()
{
    setFollowing(false);
    m_state->camera.frame(m_state->box);
    m_state->input.viewMoved();
}

void Viewport::setView(const core::SavedView& view)
{
    m_state->camera.setView(view);
    m_state->input.viewMoved();
}

void Viewport::turnTo(OrbitCamera::Side side)
{
    setFollowing(false);
    m_state->camera.turnTo(side);
    m_state->input.viewMoved();
}

void Viewport::turnModel(double angle, double seconds)
{
    if (!isFollowing() || strokeOpen())
        m_state->input.turnModel(angle, seconds);
}

void Viewport::setProjection(OrbitCamera::Projection projection)
{
    m_state->camera.setProjection(projection);
    m_state->input.viewMoved();
}

void Viewport::setInputPreferences(const InputPreferences& preferences)
{
    m_state->input.setInputPreferences(preferences);
}

void Viewport::setAppearance(const ViewAppearance& appearance)
{
    const bool isNew = appearance != std::exchange(m_state->appearance, appearance);
    m_state->scaleBar->setVisible(appearance.scaleBar);
    update();
    if (isNew)
        Q_EMIT appearanceChanged();
}

core::Shading Viewport::shading() const
{
    return shadingOf(m_state->appearance.material);
}

const ViewAppearance& Viewport::appearance() const
{
    return m_state->appearance;
}

void Viewport::setReferences(const References& references)
{
    m_state->references = references;
    update();
}

QWidget* Viewport::scaleBar() const
{
    return m_state->scaleBar;
}

const OrbitCamera& Viewport::camera() const
{
    return m_state->camera;
}

const ViewportStats& Viewport::stats() const
{
    return m_state->stats;
}

double Viewport::pixelsPerMm() const
{
    const std::optional<core::SurfaceHit> hit = m_state->input.hover();
    return m_state->camera.pixelsPerMm(hit ? hit->position : m_state->camera.pivot());
}

bool Viewport::strokeOpen() const
{
    return m_state->input.strokeOpen();
}

bool Viewport::isPressPending() const
{
    return m_state->input.isPressPending();
}

void Viewport::setAdding(bool adding)
{
    if (adding)
        setFocus();
    m_state->input.setAdding(adding);
}

void Viewport::finish()
{
    m_state->input.finish();
}

void Viewport::setPicking(bool on)
{
    m_state->input.setPicking(on);
}

void Viewport::setHover(const std::optional<core::SurfaceHit>& hit,
                        const std::shared_ptr<const core::Footprint>& footprint)
{
    m_state->input.setHover(hit, footprint);
}

/// Also called when the widget moves to another window; the scene has contexts of its own and stays.
void Viewport::initializeGL()
{
    m_state->readFramebuffer = 0;
    if (!m_state->scene) {
        m_state->scene = std::make_unique<Scene>();
        if (!m_state->scene->usable())
            showDriverProblem();
        else if (!m_state->box.isEmpty())
            m_state->scene->placeGround(m_state->box);
    }
    makeCurrent();
}

void Viewport::updateCursor()
{
    const PointerInput& input = m_state->input;
    setCursor(input.isPicking() ? pickCursor() : input.hover() || input.pointed() ? Qt::CrossCursor : Qt::ArrowCursor);
}

/// The driver promised OpenGL 3.3 (graphicsProblem() was empty) and did not keep it.
void Viewport::showDriverProblem()
{
    auto* sentence = new QLabel(tr("The model cannot be shown: the graphics driver does not do what it offers."), this);
    sentence->setObjectName(QStringLiteral("driverProblem"));
    sentence->setMargin(16);
    sentence->adjustSize();
    sentence->show();
}

void Viewport::resizeGL(int width, int height)
{
    m_state->camera.setViewport(width, height);
    m_state->updateKeyboardCursorBounds({width, height});
    m_state->input.viewMoved();
}

void Viewport::paintGL()
{
    State& s = *m_state;
    if (!s.scene->usable())
        return;
    QElapsedTimer timer;
    timer.start();
    const bool surfaceChanged = s.applyPatch();
    s.placeCursor();
    s.placeMark();
    s.placeAvatar();
    s.placeHighlight();
    s.scene->showPlane(s.brush->stroke().symmetry, s.box);
    s.scene->showSectors(s.brush->stroke().radial, s.brush->stroke().symmetry, s.box);
    const bool darkTheme = palette().window().color().lightness() < 128;
    s.scene->setAppearance(s.appearance, darkTheme);
    s.scene->showReference(seenReference(s.references, s.camera, s.box));
    s.scaleBar->setLight(isDark(backdropOf(s.appearance.background, darkTheme)));
    s.scaleBar->showFor(s.camera);
    const QSize pixels = size() * devicePixelRatioF();
    const Scene::Image image = s.scene->render(s.camera, pixels, devicePixelRatioF());
    makeCurrent();
    if (image.isDraft)
        update();
    if (image.texture)
        s.show(image, pixels, defaultFramebufferObject());

    ++s.stats.frames;
    s.stats.drawMs = image.drawMs;
    s.stats.sceneMs = image.sceneMs;
    s.stats.frameMs = milliseconds(timer);
    if (surfaceChanged)
        s.input.refreshHover();
}
} // namespace ui
