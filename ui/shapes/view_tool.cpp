#include "ui/shapes/view_tool.h"

#include "core/mesh/draw_arrays.h"
#include "core/operations/mirror_image.h"
#include "ui/input/pointer_input.h"
#include "ui/settings/brush_settings.h"
#include "ui/util/pointer_events.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/view_hint.h"

#include <QAction>
#include <QKeyEvent>
#include <QPointer>

#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double atPlane = 6; ///< pixels from the plane of symmetry within which a place is meant to be on it
} // namespace

ViewTool::ViewTool(QAction* action, const BrushSettings* brush, Viewport* viewport, const char* name)
    : QWidget(viewport)
    , m_action(action)
    , m_brush(brush)
    , m_viewport(viewport)
    , m_hint(new ViewHint("toolHint", this))
{
    setObjectName(QLatin1StringView(name));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    viewport->installEventFilter(this);
    connect(m_action, &QAction::toggled, this, &ViewTool::setOn);
    m_refresh.setSingleShot(true);
    connect(&m_refresh, &QTimer::timeout, this, [this] {
        if (!isHidden())
            refresh();
    });
    connect(brush, &BrushSettings::changed, this, &ViewTool::refreshSoon);
    connect(viewport, &Viewport::drawing, this, &ViewTool::followCamera);
    connect(viewport->input(), &PointerInput::modeChanged, this, [this](PointerMode mode) {
        if (!isHidden() && mode != PointerMode::Handles)
            end();
    });
}

void ViewTool::end()
{
    m_action->setChecked(false);
}

void ViewTool::setOn(bool on)
{
    ++m_question;
    m_isAsking = m_isRequested = false;
    clear();
    PointerInput* input = m_viewport->input();
    if (!on) {
        hide();
        m_viewport->setCursor(Qt::ArrowCursor);
        input->setMode(PointerMode::Handles, false);
        return;
    }
    input->setMode(PointerMode::Sculpt); // ends another tool of the view
    input->setMode(PointerMode::Handles);
    input->pointerLeft();
    m_viewport->setFocus();
    m_viewport->setCursor(Qt::CrossCursor);
    setGeometry(m_viewport->rect());
    show();
    raise();
    refresh();
}

void ViewTool::ask(const std::vector<core::Ray>& rays)
{
    m_isAsking = true;
    const auto answer = [tool = QPointer(this), rays, question = ++m_question](const Hits& hits) {
        if (!tool || question != tool->m_question)
            return;
        tool->m_isAsking = false;
        tool->place(rays, hits);
    };
    Q_EMIT surfaceWanted(rays, answer);
}

void ViewTool::request(const core::ModelCommand& command)
{
    m_isRequested = true;
    Q_EMIT requested(command);
}

core::Symmetry ViewTool::symmetry() const
{
    return m_brush->stroke().symmetry;
}

bool ViewTool::isAtPlane(const core::Vec3& place) const
{
    return symmetry() != core::Symmetry::None &&
           std::abs(place[core::axisOf(symmetry())]) * m_viewport->camera().pixelsPerMm(place) < atPlane;
}

void ViewTool::showTranslucent(core::TriangleMesh solid)
{
    const core::TriangleMesh both = core::besideImage(std::move(solid), symmetry());
    m_viewport->showTranslucent(
        both.triangles.empty() ? nullptr : std::make_shared<const core::DrawArrays>(core::drawArraysOf(both)));
}

void ViewTool::endRequest(bool isMade)
{
    if (std::exchange(m_isRequested, false) && isMade)
        end();
}

bool ViewTool::eventFilter(QObject* watched, QEvent* event)
{
    if (isHidden())
        return false;
    const QSinglePointEvent* pointer = pointerEventIn(*event);
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if ((pointer && handlePointer(*pointer)) || (isKey && handleKey(*static_cast<QKeyEvent*>(event)))) {
        event->accept(); // a key that is claimed triggers no action
        return true;
    }
    if (event->type() == QEvent::Wheel && isHeld())
        return true;
    if (event->type() == QEvent::Resize) {
        setGeometry(m_viewport->rect());
        refresh();
    }
    return QWidget::eventFilter(watched, event);
}

/// Draws the tool again if the camera has moved. Drawing it draws the view, so it must not happen each time.
void ViewTool::followCamera()
{
    const OrbitCamera& camera = m_viewport->camera();
    if (!isHidden() && camera.projectionMatrix() * camera.viewMatrix() != m_view)
        update();
}

void ViewTool::paintEvent(QPaintEvent*)
{
    m_view = m_viewport->camera().projectionMatrix() * m_viewport->camera().viewMatrix();
}
} // namespace ui
