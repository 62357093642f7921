#include "ui/viewport/viewport.h"

#include "ui/input/pointer_input.h"
#include "ui/input/touch_input.h"
#include "ui/scene/cursor_color.h"
#include "ui/scene/scene.h"
#include "ui/viewport/keyboard_cursor.h"
#include "ui/viewport/keyboard_cursor_overlay.h"
#include "ui/viewport/navigation_cube.h"
#include "ui/viewport/pointer_highlight.h"
#include "ui/viewport/scale_bar.h"
#include "ui/viewport/stabilizer_line.h"
#include "ui/widgets/themed_icon.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QOpenGLExtraFunctions>
#include <QTabletEvent>

#include <algorithm>
#include <chrono>
#include <cmath>
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

/// Makes the cursor for picking, whose hot spot is the tip of the icon.
QCursor pickCursor()
{
    constexpr int size = 24, tip = 3;
    return QCursor(themedIcon(QStringLiteral("pick")).pixmap(size, size), tip, size - tip);
}
constexpr double zoomPerNotch = 0.87;
constexpr double minPinch = 0.1;   ///< smallest zoom factor of one event: lower values of a touchpad are errors
constexpr double wheelNotch = 120; ///< unit of QWheelEvent: one notch of the wheel, in eighths of a degree

OrbitCamera::Pixel pixelOf(const QPointF& position)
{
    return {position.x(), position.y()};
}

PointerEvent pointerEvent(PointerEvent::Kind kind, const QSinglePointEvent& event)
{
    PointerEvent made;
    made.kind = kind;
    made.pixel = pixelOf(event.position());
    made.button = event.button();
    made.modifiers = event.modifiers();
    made.time = static_cast<double>(event.timestamp()) * 1e-3;
    return made;
}

/// Handles pinching and panning on a touchpad, on systems that distinguish them from scrolling (which arrives as wheel
/// events). Returns false for other gestures.
bool handleGesture(PointerInput& input, const QNativeGestureEvent& event)
{
    switch (event.gestureType()) {
    case Qt::ZoomNativeGesture:
        input.zoom(1 / std::max(1 + event.value(), minPinch), pixelOf(event.position()));
        return true;
    case Qt::PanNativeGesture:
        input.pan(pixelOf(event.delta()));
        return true;
    default:
        return false;
    }
}
} // namespace

struct Viewport::State
{
    explicit State(BrushSettings* settings) : brush(settings) {}

    BrushSettings* brush;
    OrbitCamera camera;
    PointerInput input{brush, &camera};
    ViewNavigation navigation{&camera, &input};
    PointerSpotlight spotlight{&input};
    TouchInput touch{&input};
    KeyboardCursor keyboardCursor{&input};
    std::unique_ptr<Scene> scene;
    ViewAppearance appearance;
    References references;
    ScaleBar* scaleBar = nullptr;
    NavigationCube* navigationCube = nullptr;
    StabilizerLine* stabilizerLine = nullptr;
    KeyboardCursorOverlay* keyboardOverlay = nullptr; ///< cross at the keyboard cursor's position
    PointerHighlight* highlight = nullptr;
    std::function<std::optional<core::MeshPatch>()> patchSource;
    std::shared_ptr<const core::Footprint> shades;
    std::optional<core::Sphere> teacher;
    std::shared_ptr<const core::DrawArrays> translucent;
    std::shared_ptr<const core::Footprint> movedVertices; ///< null: none is shown moved
    core::Transform move;
    std::optional<Cut> cut;
    bool isMoveDone = false;
    bool patchPending = false;
    unsigned int readFramebuffer = 0;
    ViewportStats stats;

    bool applyPatch();
    void placeGround();
    double cursorRadius() const;
    void placeCursor();
    void placeKeys();
    void placeMark();
    void placeGhosts();
    void placeHighlight();
    void updateKeyboardCursorBounds(const QSize& view);
    void updateStabilizerLine();
    void show(const Scene::Image& image, QSize pixels, unsigned int widgetFramebuffer);
};

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
    if (std::exchange(isMoveDone, false))
        movedVertices.reset();

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

/// Returns the radius of the cursor's ring, mm: the brush's radius, or the radius dragged so far in an open anchored
/// stroke.
double Viewport::State::cursorRadius() const
{
    const double radius = brush->value(core::Parameter::Radius);
    const auto drag = input.stabilizer();
    if (!drag || !core::isAnchored(input.stroke()))
        return radius;
    const double dragged = (drag->pointer - drag->brush).norm() / input.pixelsPerMm();
    return dragged > core::minDragged * radius ? dragged : radius;
}

void Viewport::State::placeCursor()
{
    scene->move(movedVertices, move);
    if (movedVertices)
        return scene->hideCursor();
    if (cut) {
        scene->hideCursor();
        return scene->tint(cut->vertices);
    }
    const std::optional<core::SurfaceHit> hit = input.hover();
    if (hit)
        scene->placeCursor(*hit, cursorRadius(), cursorColor(input.stroke()));
    else
        scene->hideCursor();
    const core::StrokeSettings settings = brush->stroke();
    if (hit && input.wouldStroke() && settings.brush == core::BrushShape::Sphere)
        scene->tintBall(hit->position, settings);
    else
        scene->tint(input.footprint());
}

void Viewport::State::placeGround()
{
    if (scene && scene->usable() && !navigation.box().isEmpty())
        scene->placeGround(navigation.box());
}

void Viewport::State::placeKeys()
{
    if (keyboardCursor.isOn())
        keyboardOverlay->place(QPointF(keyboardCursor.at().x(), keyboardCursor.at().y()), keyboardCursor.isDown());
    keyboardOverlay->setVisible(keyboardCursor.isOn());
}

void Viewport::State::placeMark()
{
    scene->shade(shades);
    if (const auto& mark = navigation.mark())
        scene->showMark(mark->point, mark->normal, mark->radius);
    else
        scene->hideMark();
}

void Viewport::State::placeGhosts()
{
    scene->showAvatar(navigation.shownAvatar());
    scene->showTeacher(teacher);
    scene->showTranslucent(translucent);
}

void Viewport::State::placeHighlight()
{
    const std::optional<core::SurfaceHit>& place = spotlight.place();
    if (!place)
        return highlight->place({});
    const OrbitCamera::Pixel at = camera.project(place->position);
    highlight->place(QPointF(at.x(), at.y()));
}

void Viewport::State::updateKeyboardCursorBounds(const QSize& view)
{
    keyboardCursor.setBounds(
        {OrbitCamera::Pixel(view.width(), view.height()), input.pixelsPerMm() * brush->value(core::Parameter::Radius)});
}

void Viewport::State::updateStabilizerLine()
{
    const auto stabilizer = input.stabilizer();
    stabilizerLine->setLine(stabilizer ? QLineF(stabilizer->pointer.x(), stabilizer->pointer.y(), stabilizer->brush.x(),
                                                stabilizer->brush.y())
                                       : QLineF());
}

/// Copies the scene's image into the widget's framebuffer. Precondition: the widget's OpenGL context is current.
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
    // Curves need every mouse move. Must be set here, because Qt's X11 platform turns compression on while QApplication
    // is created.
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    setMouseTracking(true);
    setTabletTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    setAccessibleName(tr("Model"));
    m_state->scaleBar = new ScaleBar(this);
    m_state->navigationCube = new NavigationCube(this);
    m_state->stabilizerLine = new StabilizerLine(this);
    m_state->highlight = new PointerHighlight(this);
    m_state->keyboardOverlay = new KeyboardCursorOverlay(this);
    connectInput();
    connect(brush, &BrushSettings::changed, this, qOverload<>(&Viewport::update));
    connect(brush, &BrushSettings::changed, &m_state->input, &PointerInput::brushChanged);
    QCoreApplication::instance()->installEventFilter(this);
}

void Viewport::connectInput()
{
    const auto repaint = qOverload<>(&Viewport::update);
    connect(&m_state->input, &PointerInput::viewChanged, this, repaint);
    connect(&m_state->input, &PointerInput::hoverChanged, this, [this] {
        updateCursor();
        m_state->updateStabilizerLine();
        update();
    });
    connect(&m_state->navigation, &ViewNavigation::followingChanged, this, repaint);
    connect(&m_state->navigation, &ViewNavigation::markChanged, this, repaint);
    connect(m_state->navigationCube, &NavigationCube::entered, &m_state->input, &PointerInput::pointerLeft);
    connect(m_state->navigationCube, &NavigationCube::sideChosen, &m_state->navigation, &ViewNavigation::turnTo);
    connect(m_state->navigationCube, &NavigationCube::turned, &m_state->navigation, &ViewNavigation::turn);
    connect(&m_state->spotlight, &PointerSpotlight::pointed, this, repaint);
    connect(&m_state->keyboardCursor, &KeyboardCursor::changed, this, [this] { m_state->placeKeys(); });
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

PointerInput* Viewport::input() const
{
    return &m_state->input;
}

ViewNavigation* Viewport::navigation() const
{
    return &m_state->navigation;
}

PointerSpotlight* Viewport::spotlight() const
{
    return &m_state->spotlight;
}

const KeyboardCursor* Viewport::keyboardCursor() const
{
    return &m_state->keyboardCursor;
}

void Viewport::setKeyboardCursor(bool on)
{
    if (on == m_state->keyboardCursor.isOn())
        return;
    m_state->updateKeyboardCursorBounds(size());
    m_state->keyboardCursor.setOn(on);
    if (on)
        setFocus();
}

void Viewport::showModel(const core::Box& box)
{
    m_state->input.finish();
    m_state->input.clearHover();
    m_state->shades.reset();
    m_state->navigation.showModel(box);
    m_state->placeGround();
}

void Viewport::setBox(const core::Box& box)
{
    m_state->navigation.setBox(box);
    m_state->placeGround();
}

void Viewport::setReducesMotion(bool reducesMotion)
{
    m_state->navigation.setReducesMotion(reducesMotion);
    m_state->highlight->setReducesMotion(reducesMotion);
}

bool Viewport::reducesMotion() const
{
    return m_state->navigation.reducesMotion();
}

void Viewport::setAppearance(const ViewAppearance& appearance)
{
    const bool isNew = appearance != std::exchange(m_state->appearance, appearance);
    m_state->scaleBar->setVisible(appearance.scaleBar);
    m_state->navigationCube->setVisible(appearance.navigationCube);
    update();
    if (isNew)
        Q_EMIT appearanceChanged();
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

void Viewport::setShades(const std::shared_ptr<const core::Footprint>& shades)
{
    m_state->shades = shades;
    update();
}

void Viewport::showMoved(const std::shared_ptr<const core::Footprint>& vertices, const core::Transform& by, bool isDone)
{
    m_state->movedVertices = vertices;
    m_state->move = by;
    m_state->isMoveDone = vertices && isDone;
    update();
}

void Viewport::showCut(const std::optional<Cut>& cut)
{
    m_state->cut = cut;
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

void Viewport::showAvatar(const std::optional<HeadsetAvatar>& avatar)
{
    if (!avatar && !m_state->navigation.shownAvatar())
        return;
    m_state->navigation.setAvatar(avatar);
    update();
}

void Viewport::showTeacher(const std::optional<core::Sphere>& brush)
{
    if (!brush && !m_state->teacher)
        return;
    m_state->teacher = brush;
    update();
    Q_EMIT teacherShown(brush);
}

void Viewport::showTranslucent(const std::shared_ptr<const core::DrawArrays>& translucent)
{
    m_state->translucent = translucent;
    update();
}

/// Creates the scene in the first call. Qt calls it again when the widget moves to another window; the scene is kept,
/// because it has contexts of its own.
void Viewport::initializeGL()
{
    m_state->readFramebuffer = 0;
    if (!m_state->scene) {
        m_state->scene = std::make_unique<Scene>();
        if (!m_state->scene->usable())
            showDriverProblem();
        m_state->placeGround();
    }
    makeCurrent();
}

void Viewport::updateCursor()
{
    const PointerInput& input = m_state->input;
    setCursor(input.mode() == PointerMode::Pick         ? pickCursor()
              : input.mode() == PointerMode::ChoosePart ? Qt::PointingHandCursor
              : input.hover() || input.pointed()        ? Qt::CrossCursor
                                                        : Qt::ArrowCursor);
}

/// Shows a message for a driver that reported OpenGL 3.3 (graphicsProblem() was empty) but does not implement it.
void Viewport::showDriverProblem()
{
    auto* sentence =
        new QLabel(tr("The model cannot be shown: the graphics driver lacks a feature that it claims to have."), this);
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
    s.placeGhosts();
    s.placeHighlight();
    if (s.cut)
        s.scene->showCut(s.cut->point, s.cut->normal, s.cut->image);
    else
        s.scene->showPlane(s.appearance.symmetryPlane ? s.brush->stroke().symmetry : core::Symmetry::None,
                           s.navigation.box());
    s.scene->showSectors(s.brush->stroke().radial, s.brush->stroke().symmetry, s.navigation.box());
    const bool darkTheme = palette().window().color().lightness() < 128;
    s.scene->setAppearance(s.appearance, darkTheme);
    s.scene->showReference(seenReference(s.references, s.camera, s.navigation.box()));
    const bool isBackdropDark = isDark(backdropOf(s.appearance.background, darkTheme));
    s.scaleBar->setLight(isBackdropDark);
    s.scaleBar->showFor(s.camera);
    s.navigationCube->setLight(isBackdropDark);
    s.navigationCube->showFor(s.camera);
    Q_EMIT drawing();
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

void Viewport::changeEvent(QEvent* event)
{
    QOpenGLWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange)
        return;
    updateCursor(); // the cursor may be an icon in the text's colour
    update();
}

/// Handles a mouse press. Mouse events are ignored while the keyboard cursor is pressed.
void Viewport::mousePressEvent(QMouseEvent* event)
{
    if (m_state->keyboardCursor.isDown())
        return;
    m_state->navigation.stop();
    m_state->input.handle(pointerEvent(PointerEvent::Kind::Press, *event));
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    if (m_state->keyboardCursor.isDown())
        return;
    m_state->spotlight.restartTimer();
    m_state->input.handle(pointerEvent(PointerEvent::Kind::Move, *event));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_state->keyboardCursor.isDown())
        return;
    m_state->input.handle(pointerEvent(PointerEvent::Kind::Release, *event));
}

/// Handles the pen. Accepts the event, because otherwise Qt would send it again as a mouse event.
void Viewport::tabletEvent(QTabletEvent* event)
{
    const auto kind = event->type() == QEvent::TabletPress     ? PointerEvent::Kind::Press
                      : event->type() == QEvent::TabletRelease ? PointerEvent::Kind::Release
                                                               : PointerEvent::Kind::Move;
    m_state->spotlight.restartTimer();
    PointerEvent pen = pointerEvent(kind, *event);
    pen.pressure = event->pressure();
    pen.isEraser = event->pointerType() == QPointingDevice::PointerType::Eraser;
    m_state->input.handle(pen);
    event->accept();
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    m_state->navigation.stop();
    const double notches = event->angleDelta().y() / wheelNotch;
    if (notches != 0)
        m_state->input.zoom(std::pow(zoomPerNotch, notches), pixelOf(event->position()));
    event->accept();
}

void Viewport::leaveEvent(QEvent* event)
{
    if (!m_state->keyboardCursor.isOn())
        m_state->input.pointerLeft();
    QOpenGLWidget::leaveEvent(event);
}

/// Handles touch, for which Qt has no separate handler. Also ends drags whose release event will not arrive: when a
/// dialog opens over the window or the view is hidden.
bool Viewport::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        m_state->touch.handle(*static_cast<QTouchEvent*>(event));
        event->accept(); // otherwise Qt would send it again as a mouse event
        return true;
    case QEvent::NativeGesture:
        if (handleGesture(m_state->input, *static_cast<QNativeGestureEvent*>(event)))
            return true;
        break;
    case QEvent::WindowBlocked:
    case QEvent::Hide:
        m_state->input.finish();
        break;
    default:
        break;
    }
    return QOpenGLWidget::event(event);
}

/// Watches modifier keys of the whole program, so that the cursor always shows the effect of a press. Esc returns to
/// PointerMode::Sculpt and takes back an open stroke.
bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease)
        m_state->input.setModifiers(static_cast<QKeyEvent*>(event)->modifiers());
    const bool isForPopup = QApplication::activePopupWidget() || QApplication::activeModalWidget();
    if (!isForPopup && event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        m_state->spotlight.setOn(false);
        m_state->input.setMode(PointerMode::Sculpt);
        if (m_state->input.strokeOpen())
            m_state->input.finish(core::StrokeEnd::TakenBack);
    }
    return QOpenGLWidget::eventFilter(watched, event);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    m_state->updateKeyboardCursorBounds(size());
    if (!m_state->keyboardCursor.press(*event))
        QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_state->keyboardCursor.release(*event))
        QOpenGLWidget::keyReleaseEvent(event);
}

/// Releases all keys, because their release events will not arrive without the focus.
void Viewport::focusOutEvent(QFocusEvent* event)
{
    m_state->keyboardCursor.releaseAll();
    QOpenGLWidget::focusOutEvent(event);
}
} // namespace ui
