#include "app/headset/partner_view.h"

#include "app/document/document.h"

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
/// The window's brush is announced when it has not changed for this time.
constexpr std::chrono::milliseconds choiceDelay(500);
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

PartnerView::PartnerView(Document* document, ui::MainWindow* window)
    : m_document(document)
    , m_window(window)
    , m_lessons(window->findChild<ui::LessonPanel*>())
{
    m_choiceTimer.setSingleShot(true);
    m_choiceTimer.setInterval(choiceDelay);
    connect(&m_choiceTimer, &QTimer::timeout, this, &PartnerView::announceChoice);
    connect(window->action(QStringLiteral("edit.undo")), &QAction::triggered, this,
            [this] { announceHistory(tr("Your partner undid: %1.").arg(m_undoText)); });
    connect(window->action(QStringLiteral("edit.redo")), &QAction::triggered, this,
            [this] { announceHistory(tr("Your partner redid: %1.").arg(m_redoText)); });
    connect(m_lessons, &ui::LessonPanel::changed, this, &PartnerView::onLessonChanged);
    connect(window->viewport(), &ui::Viewport::teacherShown, this, [this](const std::optional<core::Sphere>& brush) {
        m_teacher = brush;
        Q_EMIT changed();
    });
}

void PartnerView::begin(quint64 model)
{
    m_isVisited = true;
    m_radiusChanges = 0;
    m_pointed.reset();
    m_isTakenOver = false;
    m_isRadiusNew = m_isStepNew = false;
    m_avatarRadius = 0;
    m_knownBrush = m_window->brush()->stroke();
    m_radiusModel = model;
    m_radiusShare = m_window->brush()->radiusShare();
    m_choiceTimer.stop();
}

void PartnerView::end()
{
    m_isVisited = false;
    m_choiceTimer.stop();
}

void PartnerView::addTo(vr::DocumentUpdate& update)
{
    checkRadius(update.model);
    m_undoText = m_document->history().undoText();
    m_redoText = m_document->history().redoText();
    update.radiusChange = m_radiusChanges;
    update.pointed = m_pointed;
    update.teacher = m_teacher;
    update.lesson = m_lesson;
}

void PartnerView::point(const std::optional<core::SurfaceHit>& place)
{
    m_pointed.reset();
    if (place && m_isVisited)
        m_pointed = vr::PointedPlace{place->position, place->normal};
    Q_EMIT changed();
}

/// Detects a radius chosen by the desktop user. A change that follows the model's size, or came with another model,
/// does not count.
void PartnerView::checkRadius(quint64 model)
{
    const double share = m_window->brush()->radiusShare();
    if (m_radiusModel == model && std::abs(share - m_radiusShare) > sameShare * share) {
        ++m_radiusChanges;
        m_isRadiusNew = true;
        m_choiceTimer.start();
    }
    m_radiusModel = model;
    m_radiusShare = share;
}

/// Announces the window's brush in the headset. Changes of symmetry, topology and colour are only felt as haptics;
/// tools selected by a lesson's step are not announced.
void PartnerView::announceChoice()
{
    if (!m_isVisited)
        return;
    const core::StrokeSettings brush = m_window->brush()->stroke(), before = std::exchange(m_knownBrush, brush);
    const bool isRadiusNew = std::exchange(m_isRadiusNew, false);
    if (std::exchange(m_isStepNew, false))
        return;
    const double radius = isRadiusNew || m_avatarRadius <= 0 ? brush.radius : m_avatarRadius;
    if (brush.tool != before.tool || isRadiusNew)
        //: %1: a tool; %2: a length
        Q_EMIT noticed(
            tr("Your partner chose %1, %2 mm.").arg(StrokeStep::textOf(brush.tool), ui::PartnerBar::figures(radius)));
    else if (brush.strength != before.strength)
        Q_EMIT noticed(tr("Your partner chose a strength of %1 %.").arg(std::lround(brush.strength * 100)));
}

void PartnerView::setKnownBrush(const core::StrokeSettings& brush)
{
    m_knownBrush = brush;
    if (!m_window->brush()->tools()->sharesRadius())
        m_radiusShare = m_window->brush()->radiusShare();
}

void PartnerView::announceHistory(const QString& sentence)
{
    if (m_isVisited)
        Q_EMIT noticed(sentence);
}

void PartnerView::setTakenOver(bool isTakenOver)
{
    if (!m_isVisited || isTakenOver == m_isTakenOver)
        return;
    m_isTakenOver = isTakenOver;
    Q_EMIT takenOver(isTakenOver);
    Q_EMIT noticed(isTakenOver ? tr("Your partner is sculpting now.") : tr("It is your turn again."));
}

void PartnerView::refuse()
{
    Q_EMIT noticed(tr("Your partner is sculpting now."));
    Q_EMIT brushRefused();
}

void PartnerView::onLessonChanged()
{
    const std::optional<vr::LessonPanel> before = std::exchange(m_lesson, std::nullopt);
    if (m_lessons && m_lessons->shown())
        m_lesson = lessonOf(*m_lessons->shown());
    if (m_lesson && (!before || before->step != m_lesson->step)) {
        m_isStepNew = true;
        m_choiceTimer.start();
    }
    Q_EMIT changed();
}

void PartnerView::press(vr::LessonRequest button)
{
    if (m_lessons)
        m_lessons->press(static_cast<ui::LessonButton>(button));
}
} // namespace app
