#include "ui/classroom/answer_scale.h"

#include "ui/classroom/questionnaire.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int pointWidth = 44, narrowPointWidth = 24, pointHeight = 34; ///< pixels
/// Characters of each end's words for which there must be room beside the points; otherwise the scale is narrow.
constexpr int endCharacters = 14;

QLabel* endLabel(const QString& text)
{
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    return label;
}
} // namespace

AnswerScale::AnswerScale(const QString& name, const QuestionWords& words)
    : m_row(new QHBoxLayout)
    , m_below(new QHBoxLayout)
    , m_low(endLabel(words.low))
    , m_high(endLabel(words.high))
{
    setObjectName(name);
    setAccessibleName(words.question);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(m_row);
    column->addLayout(m_below);
    m_row->setSpacing(gap / 2);
    m_below->setSpacing(gap);
    for (int point = minAnswer; point <= maxAnswer; ++point)
        m_row->addWidget(addPoint(point, name, words));
    arrange(m_isNarrow);
    reachByTab(minAnswer);
}

/// Arranges the parts for a narrow or wide scale. If wide, both ends get half of the width left of the points, whatever
/// their words, so that the scales of a form are aligned.
void AnswerScale::arrange(bool isNarrow)
{
    m_isNarrow = isNarrow;
    for (QToolButton* point : m_points) {
        point->setMinimumSize(isNarrow ? narrowPointWidth : pointWidth, pointHeight);
        point->setSizePolicy(isNarrow ? QSizePolicy::Expanding : QSizePolicy::Fixed, QSizePolicy::Fixed);
    }
    for (QLabel* end : {m_low, m_high}) {
        m_row->removeWidget(end);
        m_below->removeWidget(end);
        end->setSizePolicy(isNarrow ? QSizePolicy::Preferred : QSizePolicy::Ignored, QSizePolicy::Preferred);
        end->setIndent(isNarrow ? 0 : gap / 2);
    }
    if (isNarrow) {
        m_below->addWidget(m_low);
        m_below->addWidget(m_high);
    } else {
        m_row->insertWidget(0, m_low, 1);
        m_row->addWidget(m_high, 1);
    }
    m_low->setAlignment(isNarrow ? Qt::AlignLeft | Qt::AlignTop : Qt::AlignRight | Qt::AlignVCenter);
    m_high->setAlignment(isNarrow ? Qt::AlignRight | Qt::AlignTop : Qt::AlignLeft | Qt::AlignVCenter);
}

void AnswerScale::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int points = maxAnswer * (pointWidth + gap / 2);
    const bool isNarrow = width() < points + 2 * endCharacters * fontMetrics().averageCharWidth();
    if (isNarrow != m_isNarrow)
        arrange(isNarrow);
}

QToolButton* AnswerScale::addPoint(int point, const QString& name, const QuestionWords& words)
{
    const QString digit = QString::number(point);
    const QString end = point == minAnswer ? words.low : point == maxAnswer ? words.high : QString();
    QStringList spoken{words.question, tr("%1 of %2").arg(digit, QString::number(maxAnswer)), end};
    spoken.removeAll(QString());
    auto* button = named(new QToolButton, name + u'.' + digit, end, spoken.join(u' '));
    button->setText(digit);
    button->setCheckable(true);
    button->installEventFilter(this);
    connect(button, &QToolButton::clicked, this,
            [this, point](bool isChosen) { choose(isChosen ? std::optional(point) : std::nullopt); });
    m_points << button;
    return button;
}

void AnswerScale::setAnswer(std::optional<int> answer)
{
    m_answer = answer;
    for (int point = minAnswer; point <= maxAnswer; ++point)
        m_points[point - minAnswer]->setChecked(answer == point);
    reachByTab(answer.value_or(minAnswer));
}

void AnswerScale::choose(std::optional<int> answer)
{
    const bool hasFocus = std::ranges::any_of(m_points, &QWidget::hasFocus);
    const int reached = answer.value_or(m_reached);
    setAnswer(answer);
    if (hasFocus)
        moveTo(reached);
    Q_EMIT changed();
}

bool AnswerScale::takeKey(int key)
{
    switch (key) {
    case Qt::Key_Left:
        moveTo(m_reached - 1);
        return true;
    case Qt::Key_Right:
        moveTo(m_reached + 1);
        return true;
    case Qt::Key_Home:
        moveTo(minAnswer);
        return true;
    case Qt::Key_End:
        moveTo(maxAnswer);
        return true;
    case Qt::Key_Up:
        return focusNextPrevChild(false);
    case Qt::Key_Down:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return focusNextPrevChild(true);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        choose({});
        return true;
    default:
        break;
    }
    const int point = key - Qt::Key_0;
    if (point < minAnswer || point > maxAnswer)
        return false;
    choose(point);
    return true;
}

void AnswerScale::moveTo(int point)
{
    reachByTab(std::clamp(point, minAnswer, maxAnswer));
    m_points[m_reached - minAnswer]->setFocus(Qt::TabFocusReason);
}

void AnswerScale::reachByTab(int point)
{
    m_reached = point;
    for (int i = minAnswer; i <= maxAnswer; ++i)
        m_points[i - minAnswer]->setFocusPolicy(i == point ? Qt::StrongFocus : Qt::ClickFocus);
    setFocusProxy(m_points[point - minAnswer]);
}

bool AnswerScale::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn)
        reachByTab(static_cast<int>(m_points.indexOf(watched)) + minAnswer);
    if (event->type() == QEvent::KeyPress) {
        const auto* press = static_cast<const QKeyEvent*>(event);
        if (!(press->modifiers() & ~Qt::KeypadModifier) && takeKey(press->key()))
            return true;
    }
    return QWidget::eventFilter(watched, event);
}
} // namespace ui
