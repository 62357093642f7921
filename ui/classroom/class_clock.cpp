#include "ui/classroom/class_clock.h"

#include "ui/classroom/class_bar.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMouseEvent>
#include <QScreen>
#include <QStyle>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
/// Width of the clock: a fifth of the view's width, within these limits in pixels.
constexpr int clockShare = 5, minClockWidth = 160, maxClockWidth = 320;
/// Height of the clock as a fraction of its width.
constexpr double clockHeight = 0.625;
/// Letter heights as divisors of the clock's height: 7 means 1/7.
constexpr int nameShare = 7, timeShare = 3, nextShare = 14;
constexpr int minClockLetters = 10;  ///< smallest letter height, pixels
constexpr int maxLettersAcross = 12; ///< characters of the time that must fit the width

/// Sets the letter height in pixels; reduces it if the text is wider than the label.
void setLetters(QLabel* label, int pixels)
{
    QFont font = label->font();
    font.setPixelSize(std::max(pixels, minClockLetters));
    while (font.pixelSize() > minClockLetters && QFontMetrics(font).horizontalAdvance(label->text()) > label->width())
        font.setPixelSize(font.pixelSize() - 1);
    label->setFont(font);
}
} // namespace

ClassClock::ClassClock(const QString& title, const QStringList& names, QMainWindow* window)
    : QWidget(window, Qt::Window)
    , m_names(names)
    , m_window(window)
    , m_pupil(named(new QLabel, "clockPupil"))
    , m_time(named(new QLabel, "clockTime"))
    , m_next(named(new QLabel, "clockNext"))
{
    setObjectName(QStringLiteral("classClock"));
    setWindowTitle(title);
    setContextMenuPolicy(Qt::PreventContextMenu);
    auto* column = new QVBoxLayout(this);
    for (QLabel* label : {m_pupil, m_time, m_next}) {
        label->setTextFormat(Qt::PlainText);
        label->setAlignment(Qt::AlignCenter);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
        column->addWidget(label, label == m_time ? 2 : 1);
    }
    setPupil({});
}

void ClassClock::setPupil(const std::optional<QString>& pupil)
{
    m_present = pupil.value_or(QString());
    m_pupil->setText(m_present);
    showNext();
}

void ClassClock::setTime(const std::optional<TurnTime>& time)
{
    if (!time)
        m_time->clear();
    else if (time->seconds > 0)
        m_time->setText(clockText(time->seconds));
    else
        m_time->setText(QStringLiteral("+") + clockText(time->over));
}

void ClassClock::setHadTurn(const QStringList& pupils)
{
    m_hadTurn = pupils;
    showNext();
}

void ClassClock::showNext()
{
    const auto next = std::ranges::find_if(
        m_names, [this](const QString& name) { return name != m_present && !m_hadTurn.contains(name); });
    m_next->setText(next == m_names.end() ? QString() : tr("Next: %1").arg(*next));
    fit();
}

void ClassClock::toggle()
{
    if (isVisible())
        return hide();
    const QList<QScreen*> screens = QGuiApplication::screens();
    const auto other =
        std::ranges::find_if(screens, [this](const QScreen* screen) { return screen != m_window->screen(); });
    if (other == screens.end()) {
        if (!std::exchange(m_isPlaced, true))
            placeInView();
        return show();
    }
    setGeometry((*other)->geometry());
    showFullScreen();
}

/// Places the clock in the lower left corner of the view, away from menus, bars and panels.
void ClassClock::placeInView()
{
    setWindowFlags(Qt::Dialog); // a dialog stays above the class's window
    const QWidget* view = m_window->centralWidget();
    const int width = std::clamp(view->width() / clockShare, minClockWidth, maxClockWidth);
    resize(width, static_cast<int>(clockHeight * width));
    // Estimate of the height of the window manager's title bar
    const int title = style()->pixelMetric(QStyle::PM_TitleBarHeight);
    move(view->mapToGlobal(QPoint(gap, view->height() - gap - height() - title)));
}

void ClassClock::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        hide();
}

/// Starts moving the clock, so that it can be moved without a title bar too.
void ClassClock::mousePressEvent(QMouseEvent* event)
{
    m_grip = event->globalPosition().toPoint() - pos();
}

void ClassClock::mouseMoveEvent(QMouseEvent* event)
{
    if (!isFullScreen() && event->buttons() == Qt::LeftButton)
        move(event->globalPosition().toPoint() - m_grip);
}

void ClassClock::fit()
{
    setLetters(m_pupil, height() / nameShare);
    setLetters(m_time, std::min(height() / timeShare, 2 * width() / maxLettersAcross));
    setLetters(m_next, height() / nextShare);
}

void ClassClock::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}
} // namespace ui
