#include "ui/classroom/class_bar.h"

#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QStyle>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int clockSize = 18;                            ///< pixels
constexpr int maxNameWidth = 240, maxResumedWidth = 120; ///< pixels; widths of names in texts and on the button Resume
constexpr int minTextWidth = 56;                         ///< pixels; smallest width of a truncated text

/// A label that ends in "…" if the bar is too narrow, so that the bar hides no button to make room for text.
class CutLabel : public QLabel
{
public:
    QSize minimumSizeHint() const override
    {
        const QSize whole = QLabel::minimumSizeHint();
        return {std::min(whole.width(), minTextWidth), whole.height()};
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const QRect room = contentsRect();
        style()->drawItemText(&painter, room, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), palette(),
                              isEnabled(), fontMetrics().elidedText(text(), Qt::ElideRight, room.width()),
                              foregroundRole());
    }
};

void setBold(QWidget* widget, bool isBold)
{
    QFont font = widget->font();
    font.setBold(isBold);
    widget->setFont(font);
}

/// Adds the button to the bar with margins around it. Both Return and Space press it.
QPushButton* addButton(QToolBar* bar, QPushButton* button)
{
    button->setAutoDefault(true);
    auto* cell = new QWidget;
    auto* row = new QHBoxLayout(cell);
    row->setContentsMargins(0, gap / 2, gap, gap / 2);
    row->addWidget(button);
    bar->addWidget(cell);
    return button;
}
} // namespace

QString clockText(int seconds)
{
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

ClassBar::ClassBar(const QString& title, QMainWindow* window) : QToolBar(tr("Class"), window)
{
    setObjectName(QStringLiteral("classBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    auto* name = addLabel("classTitle", new CutLabel);
    name->setText(title);
    name->setToolTip(title);
    m_pupil = addLabel("classPupil", new CutLabel);
    for (QLabel* label : {name, m_pupil})
        label->setMaximumWidth(maxNameWidth);
    setBold(m_pupil, true);
    auto* middle = new QWidget;
    middle->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(middle);
    m_undelivered = addLabel("classWaiting", new CutLabel);
    m_clock = addLabel("classClock", new QLabel);
    m_time = addLabel("classTime", new QLabel);
    m_resume = addButton(this, named(new QPushButton, "classResume",
                                     tr("Undoes Next Pupil: reopens the pupil's work and continues the turn. Possible "
                                        "until somebody sculpts.")));
    m_resumeCell = actions().constLast();
    auto* clock = addButton(this, named(new QPushButton(tr("&Clock")), "classClockButton",
                                        tr("Shows a large clock in a window of its own, for the projector.")));
    connect(clock, &QPushButton::clicked, this, &ClassBar::clockRequested);
    m_next =
        addButton(this, named(new QPushButton(tr("&Next Pupil")), "classNext",
                              tr("Saves the work in the class folder, and begins the next turn with fresh clay.")));
    m_leave = addButton(this, named(new QPushButton(tr("&Leave…")), "classLeave",
                                    tr("Asks for the teacher's PIN, saves the work, and ends the class.")));
    connect(m_resume, &QPushButton::clicked, this, &ClassBar::resumeRequested);
    connect(m_next, &QPushButton::clicked, this, &ClassBar::nextRequested);
    connect(m_leave, &QPushButton::clicked, this, &ClassBar::leaveRequested);
    setPupil({});
    setTime({});
    setResumable({});
    setUndelivered(0, {});
    const auto bars = window->findChildren<QToolBar*>(Qt::FindDirectChildrenOnly);
    window->insertToolBar(bars.constFirst(), this);
    window->insertToolBarBreak(bars.constFirst());
}

QLabel* ClassBar::addLabel(const char* name, QLabel* label)
{
    named(label, name);
    label->setTextFormat(Qt::PlainText);
    label->setContentsMargins(gap, 0, gap, 0);
    addWidget(label);
    return label;
}

void ClassBar::setPupil(const std::optional<QString>& pupil)
{
    m_isTurn = pupil.has_value();
    m_pupil->setText(pupil.value_or(QString()));
    m_pupil->setToolTip(pupil.value_or(QString()));
    enable();
    Q_EMIT pupilShown(pupil);
}

/// Near the end of a turn, bold text and a clock icon warn; colour alone would not be enough.
void ClassBar::setTime(const std::optional<TurnTime>& time)
{
    const bool isNear = time && time->isNearEnd;
    m_clock->setPixmap(isNear ? themedIcon(QStringLiteral("clock")).pixmap(clockSize, clockSize) : QPixmap());
    setBold(m_time, isNear);
    if (!time)
        m_time->clear();
    else if (time->seconds == 0)
        m_time->setText(tr("Time is up"));
    else if (time->seconds < 60)
        m_time->setText(tr("%n seconds left", nullptr, time->seconds));
    else
        m_time->setText(tr("%n minutes left", nullptr, minutesOf(time->seconds)));
    Q_EMIT timeShown(time);
}

void ClassBar::setResumable(const std::optional<QString>& pupil)
{
    if (pupil)
        m_resume->setText(tr("&Resume %1's Turn")
                              .arg(fontMetrics()
                                       .elidedText(*pupil, Qt::ElideRight, maxResumedWidth)
                                       .replace(u'&', QStringLiteral("&&"))));
    m_resumeCell->setVisible(pupil.has_value());
}

void ClassBar::setUndelivered(int works, const QString& tip)
{
    m_undelivered->setText(works == 0 ? QString() : tr("%n models not yet in the class folder", nullptr, works));
    m_undelivered->setToolTip(tip);
}

void ClassBar::setBusy(bool isBusy)
{
    m_isBusy = isBusy;
    enable();
}

void ClassBar::enable()
{
    m_next->setEnabled(m_isTurn && !m_isBusy);
    m_resume->setEnabled(!m_isBusy);
    m_leave->setEnabled(!m_isBusy);
}
} // namespace ui
