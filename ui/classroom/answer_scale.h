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

/// A question's scale: a button for each point, of which one or none is chosen. A second click takes the choice back.
///
/// The words at its ends stand beside the points, or below them where there is not width enough; then the points are
/// narrower, too. The Tab key stops at one point only; the arrows lead to the others and to other scales, Space, digits
/// and Delete choose, and Return goes on. Thread: gui.
class AnswerScale : public QWidget
{
    Q_OBJECT

public:
    /// Names each point's object by the scale's name, a dot and its digit.
    AnswerScale(const QString& name, const QuestionWords& words);

    std::optional<int> answer() const { return m_answer; }
    /// Sets the answer; emits nothing.
    void setAnswer(std::optional<int> answer);

Q_SIGNALS:
    /// Emitted when a person has chosen, or taken the choice back.
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
    int m_reached = 1;            ///< the point that Tab reaches
    QHBoxLayout *m_row, *m_below; ///< of the points, and of the ends where it is narrow
    QLabel *m_low, *m_high;
    QList<QToolButton*> m_points;
    bool m_isNarrow = false;
};
} // namespace ui
