#pragma once

#include <QList>
#include <QWidget>

#include <optional>

class QHBoxLayout;
class QKeyEvent;
class QLabel;
class QToolButton;

namespace ui
{
struct QuestionWords;

/// A question's scale: a button for each point, at most one chosen. A second click on the chosen point clears the
/// choice.
///
/// The words of the ends are beside the points, or below them if the scale is narrow. Tab stops at one point only;
/// arrow keys move to the other points and to other scales. Space, digits and Delete choose, and Return moves on.
/// Thread: gui.
class AnswerScale : public QWidget
{
    Q_OBJECT

public:
    /// `name`: object name of the scale; a point's object name is the scale's, a dot and the digit.
    AnswerScale(const QString& name, const QuestionWords& words);

    std::optional<int> answer() const { return m_answer; }
    /// Sets the answer without emitting changed().
    void setAnswer(std::optional<int> answer);

Q_SIGNALS:
    /// The user has chosen a point or cleared the choice.
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* addPoint(int point, const QString& name, const QuestionWords& words);
    void choose(std::optional<int> answer);
    bool takeKey(int key);
    void moveTo(int point);
    void reachByTab(int point);
    void arrange(bool isNarrow);

    std::optional<int> m_answer;
    int m_reached = 1;            ///< point that Tab stops at
    QHBoxLayout *m_row, *m_below; ///< row of the points; row below for the ends if narrow
    QLabel *m_low, *m_high;
    QList<QToolButton*> m_points;
    bool m_isNarrow = false;
};
} // namespace ui
