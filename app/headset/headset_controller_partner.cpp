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
constexpr std::chrono::milliseconds choiceSettles(500); ///< a slider is told when it rests
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

void HeadsetDesk::hearPartner()
{
    m_choice.setSingleShot(true);
    m_choice.setInterval(choiceSettles);
    connect(&m_choice, &QTimer::timeout, this, &HeadsetDesk::tellChoice);
    connect(m_window->action(QStringLiteral("edit.undo")), &QAction::triggered, this,
            [this] { tellHistory(tr("Your partner took back: %1.").arg(m_undoText)); });
    connect(m_window->action(QStringLiteral("edit.redo")), &QAction::triggered, this,
            [this] { tellHistory(tr("Your partner did again: %1.").arg(m_redoText)); });
    m_lessons = m_window->findChild<ui::LessonPanel*>();
    connect(m_lessons, &ui::LessonPanel::changed, this, &HeadsetDesk::takeLesson);
    connect(m_window->viewport(), &ui::Viewport::teacherShown, this, [this](const std::optional<core::Sphere>& brush) {
        m_news.teacher = brush;
        tellSoon();
    });
}

/// A visit begins.
void HeadsetDesk::beginPartner()
{
    m_news.radiusChange = 0;
    m_news.pointed.reset();
    m_isTakenOver = false;
    m_isRadiusNew = m_isStepNew = false;
    m_wearerRadius = 0;
    m_toldBrush = m_window->brush()->stroke();
    m_radiusModel = m_news.model;
    m_radiusShare = m_window->brush()->radiusShare();
    m_choice.stop();
}

void HeadsetDesk::point(const std::optional<core::SurfaceHit>& place)
{
    m_news.pointed.reset();
    if (place && m_port)
        m_news.pointed = vr::PointedPlace{place->position, place->normal};
    tellSoon();
}

/// A radius that follows the model's size, or came with another model, is nobody's choice.
void HeadsetDesk::takeRadius()
{
    const double share = m_window->brush()->radiusShare();
    if (m_radiusModel == m_news.model && std::abs(share - m_radiusShare) > sameShare * share) {
        ++m_news.radiusChange;
        m_isRadiusNew = true;
        m_choice.start();
    }
    m_radiusModel = m_news.model;
    m_radiusShare = share;
}

/// Of symmetry, topology and colour a tick in the hand is enough; the tools of a lesson's step are nobody's choice.
void HeadsetDesk::tellChoice()
{
    if (!m_port)
        return;
    const core::StrokeSettings brush = m_window->brush()->stroke(), before = std::exchange(m_toldBrush, brush);
    const bool isRadiusNew = std::exchange(m_isRadiusNew, false);
    if (std::exchange(m_isStepNew, false))
        return;
    const double radius = isRadiusNew || m_wearerRadius <= 0 ? brush.radius : m_wearerRadius;
    if (brush.tool != before.tool || isRadiusNew)
        //: %1: a tool; %2: a length
        tellNotice(
            tr("Your partner chose %1, %2 mm.").arg(StrokeStep::textOf(brush.tool), ui::PartnerBar::figures(radius)));
    else if (brush.strength != before.strength)
        tellNotice(tr("Your partner chose a strength of %1 %.").arg(std::lround(brush.strength * 100)));
}

void HeadsetDesk::tellHistory(const QString& sentence)
{
    if (m_port)
        tellNotice(sentence);
}

void HeadsetDesk::setTakenOver(bool isTakenOver)
{
    if (!m_port || isTakenOver == m_isTakenOver)
        return;
    m_isTakenOver = isTakenOver;
    m_port->setTakenOver(isTakenOver);
    tellNotice(isTakenOver ? tr("Your partner sculpts now.") : tr("It is your turn again."));
}

/// What changes the model, or the brush that both have.
bool HeadsetDesk::isForbidden(const vr::DocumentRequest& wish) const
{
    return m_isTakenOver && !std::holds_alternative<vr::HeadsetSettings>(wish) &&
           !std::holds_alternative<vr::SaveModel>(wish);
}

/// The brush is told back, too.
void HeadsetDesk::forbid()
{
    tellNotice(tr("Your partner sculpts now."));
    ++m_news.brushChange;
}

void HeadsetDesk::takeLesson()
{
    const std::optional<vr::LessonPanel> before = std::exchange(m_news.lesson, std::nullopt);
    if (m_lessons && m_lessons->shown())
        m_news.lesson = lessonOf(*m_lessons->shown());
    if (m_news.lesson && (!before || before->step != m_news.lesson->step)) {
        m_isStepNew = true;
        m_choice.start();
    }
    tellSoon();
}

void HeadsetDesk::obey(vr::LessonRequest wish)
{
    if (m_lessons)
        m_lessons->press(static_cast<ui::LessonButton>(wish));
}
} // namespace app
