#pragma once

#include <QImage>
#include <QList>
#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace ui
{
class Actions;
class SideColumn;

/// A lesson that may be chosen.
struct LessonCard
{
    QString name; ///< by which it is asked for
    QString title, summary;
    QImage picture;
};

/// A step as the pupil reads it.
struct LessonPage
{
    QString lesson, title, text;
    QImage picture; ///< may be null
    int step = 0;   ///< from 0; `steps`: the page after the last
    int steps = 1;
    bool isShown = false;    ///< the teacher has strokes for it
    bool isCompared = false; ///< with a shape: there is a difference to be seen
    QString brush;           ///< tools and their sizes; may be empty
};

/// One thing that the step's checkpoint asks for.
struct LessonMark
{
    bool holds = false;
    QString text;
};

/// A step as it stands now.
struct LessonPanelState
{
    LessonPage page;
    QList<LessonMark> marks;
    bool isPlaying = false;
};
enum class LessonButton { Play, Try, Back, Next };

/// A lesson beside the model: what to do, what the teacher does, and whether it is done. Knows no lesson file and no
/// mesh: it says what is wanted and shows what it is given. Thread: gui.
class LessonPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LessonPanel(QWidget* parent = nullptr);

    /// To choose from, when none is open.
    void setLessons(const QList<LessonCard>& lessons);
    /// `marks`: what is to be measured; of the page after the last, what was achieved.
    void showPage(const LessonPage& page, const QList<LessonMark>& marks);
    void showLessons();
    /// Takes away what leads to files and other lessons.
    void lock();

    void setPlaying(bool isPlaying);
    void setProgress(double share); ///< of the teacher's strokes, 0 to 1
    /// Shows what the model has as it is, or pale, as it was before. Empty: nothing is asked.
    void setMarks(const QList<LessonMark>& marks, bool areOfPresent = true);
    bool wantsDifference() const;

    /// What the pupil reads; nothing: no lesson is open. changed() tells of another.
    const std::optional<LessonPanelState>& shown() const { return m_shown; }
    /// As by the buttons, from elsewhere; what their state forbids is not done.
    void press(LessonButton button);

Q_SIGNALS:
    void changed();
    void lessonChosen(const QString& name);
    void fileRequested();
    void stepRequested(int step);
    void playRequested(bool on);
    void singleStrokeRequested(); ///< the teacher's next stroke alone
    void speedChosen(double speed);
    void tryRequested();
    /// Requests that the step begin with the model that the teacher has at its start.
    void teachersModelRequested();
    void differenceRequested(bool on);
    void handoutRequested();
    void closed();

private:
    void addChooser();
    void addHead(QVBoxLayout* page);
    void addNavigation(QVBoxLayout* page);
    void addText(QVBoxLayout* page);
    void addTeacher(QVBoxLayout* page);
    void addGoals(QVBoxLayout* page);

    QStackedWidget* m_stack = nullptr;
    QVBoxLayout* m_cards = nullptr;
    QList<QWidget*> m_waysOut; ///< to files and other lessons
    QLabel *m_chooserHead = nullptr, *m_lesson = nullptr, *m_title = nullptr, *m_picture = nullptr, *m_text = nullptr,
           *m_brush = nullptr, *m_marks = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton *m_play = nullptr, *m_one = nullptr, *m_try = nullptr, *m_back = nullptr, *m_next = nullptr,
                *m_teachers = nullptr;
    QComboBox* m_speed = nullptr;
    QCheckBox* m_difference = nullptr;
    std::optional<LessonPanelState> m_shown;
    int m_step = 0;
    bool m_isPlaying = false;
};

/// Adds the panel to the column; help.lessons opens it.
void addLessonPanel(SideColumn* column, const Actions& actions);
} // namespace ui
