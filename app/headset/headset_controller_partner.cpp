// What somebody at the window does for the person in the headset: points, chooses, takes over, gives a lesson.

#include "app/headset/headset_controller.h"

#include "app/document/document.h"
#include "app/worker/stroke_step.h"

#include "ui/headset/partner_bar.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/settings/brush_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QAction>

#include <chrono>
#include <cmath>
#include <utility>

namespace app
{
namespace
{
constexpr std::chrono::milliseconds choiceDelay(500); ///< a slider is told when it rests
constexpr double sameShare = 1e-9;
static_assert(static_cast<int>(vr::LessonRequest::Next) == static_cast<int>(ui::LessonButton::Next));

vr::LessonPanel lessonOf(const ui::LessonPanelState& shown)
{
    vr::LessonPanel panel{shown.page.lesson,  shown.page.title, shown.page.text, shown.page.step, shown.page.steps, {},
                          shown.page.isShown, shown.isPlaying};
    for (const ui::LessonMark& mark : shown.marks)
        panel.marks.append({mark.text, mark.holds});
    return panel;
}
} // namespace

void HeadsetController::connectPartner()
{
    m_choiceTimer.setSingleShot(true);
    m_choiceTimer.setInterval(choiceDelay);
    connect(&m_choiceTimer, &QTimer::timeout, this, &HeadsetController::announceChoice);
    connect(m_window->action(QStringLiteral("edit.undo")), &QAction::triggered, this,
            [this] { announceHistory(tr("Your partner took back: %1.").arg(m_undoText)); });
    connect(m_window->action(QStringLiteral("edit.redo")), &QAction::triggered, this,
            [this] { announceHistory(tr("Your partner did again: %1.").arg(m_redoText)); });
    m_lessons = m_window->findChild<ui::LessonPanel*>();
    connect(m_lessons, &ui::LessonPanel::changed, this, &HeadsetController::onLessonChanged);
    connect(m_window->viewport(), &ui::Viewport::teacherShown, this, [this](const std::optional<core::Sphere>& brush) {
        m_update.teacher = brush;
        scheduleUpdate();
    });
}

/// A visit begins.
void HeadsetController::beginPartner()
{
    m_update.radiusChange = 0;
    m_update.pointed.reset();
    m_isTakenOver = false;
    m_isRadiusNew = m_isStepNew = false;
    m_avatarRadius = 0;
    m_knownBrush = m_window->brush()->stroke();
    m_radiusModel = m_update.model;
    m_radiusShare = m_window->brush()->radiusShare();
    m_choiceTimer.stop();
}

void HeadsetController::point(const std::optional<core::SurfaceHit>& place)
{
    m_update.pointed.reset();
    if (place && m_port)
        m_update.pointed = vr::PointedPlace{place->position, place->normal};
    scheduleUpdate();
}

/// A radius that follows the model's size, or came with another model, is nobody's choice.
void HeadsetController::checkRadius()
{
    const double share = m_window->brush()->radiusShare();
    if (m_radiusModel == m_update.model && std::abs(share - m_radiusShare) > sameShare * share) {
        ++m_update.radiusChange;
        m_isRadiusNew = true;
        m_choiceTimer.start();
    }
    m_radiusModel = m_update.model;
    m_radiusShare = share;
}

/// Of symmetry, topology and colour a tick in the hand is enough; the tools of a lesson's step are nobody's choice.
void HeadsetController::announceChoice()
{
    if (!m_port)
        return;
    const core::StrokeSettings brush = m_window->brush()->stroke(), before = std::exchange(m_knownBrush, brush);
    const bool isRadiusNew = std::exchange(m_isRadiusNew, false);
    if (std::exchange(m_isStepNew, false))
        return;
    const double radius = isRadiusNew || m_avatarRadius <= 0 ? brush.radius : m_avatarRadius;
    if (brush.tool != before.tool || isRadiusNew)
        //: %1: a tool; %2: a length
        showNotice(
            tr("Your partner chose %1, %2 mm.").arg(StrokeStep::textOf(brush.tool), ui::PartnerBar::figures(radius)));
    else if (brush.strength != before.strength)
        showNotice(tr("Your partner chose a strength of %1 %.").arg(std::lround(brush.strength * 100)));
}

void HeadsetController::announceHistory(const QString& sentence)
{
    if (m_port)
        showNotice(sentence);
}

void HeadsetController::setTakenOver(bool isTakenOver)
{
    if (!m_port || isTakenOver == m_isTakenOver)
        return;
    m_isTakenOver = isTakenOver;
    m_port->setTakenOver(isTakenOver);
    showNotice(isTakenOver ? tr("Your partner sculpts now.") : tr("It is your turn again."));
}

/// What changes the model, or the brush that both have.
bool HeadsetController::isForbidden(const vr::DocumentRequest& request) const
{
    return m_isTakenOver && !std::holds_alternative<vr::HeadsetSettings>(request) &&
           !std::holds_alternative<vr::SaveModel>(request);
}

/// The brush is told back, too.
void HeadsetController::rejectRequest()
{
    showNotice(tr("Your partner sculpts now."));
    ++m_update.brushChange;
}

void HeadsetController::onLessonChanged()
{
    const std::optional<vr::LessonPanel> before = std::exchange(m_update.lesson, std::nullopt);
    if (m_lessons && m_lessons->shown())
        m_update.lesson = lessonOf(*m_lessons->shown());
    if (m_update.lesson && (!before || before->step != m_update.lesson->step)) {
        m_isStepNew = true;
        m_choiceTimer.start();
    }
    scheduleUpdate();
}

void HeadsetController::handle(vr::LessonRequest request)
{
    if (m_lessons)
        m_lessons->press(static_cast<ui::LessonButton>(request));
}
} // namespace app
