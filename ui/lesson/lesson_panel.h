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

/// An entry of the list of lessons.
struct LessonCard
{
    QString name; ///< identifies the lesson in lessonChosen()
    QString title, summary;
    QImage picture;
};

/// The content of the panel for a step of a lesson.
struct LessonPage
{
    QString lesson, title, text;
    QImage picture; ///< null: no picture
    int step = 0;   ///< index of the step; equal to `steps` on the page after the last step
    int steps = 1;
    bool isShown = false;    ///< the teacher has recorded strokes for this step
    bool isCompared = false; ///< the checkpoint compares shapes, so a difference can be shown
    QString brush;           ///< tools and their sizes; may be empty
};

/// A condition of the step's checkpoint.
struct LessonMark
{
    bool holds = false;
    QString text;
};

/// The present state of the panel.
struct LessonPanelState
{
    LessonPage page;
    QList<LessonMark> marks;
    bool isPlaying = false;
};
enum class LessonButton { Play, Try, Back, Next };

/// A panel that leads a pupil through a lesson: the instructions, playback of the teacher's strokes, and the conditions
/// that are met. Knows neither lesson files nor meshes: setters provide what is shown, and signals request changes.
/// Thread: gui.
class LessonPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LessonPanel(QWidget* parent = nullptr);

    /// Adds lessons to the list that is shown while no lesson is open.
    void setLessons(const QList<LessonCard>& lessons);
    /// Shows a page. `marks`: the conditions of the step; on the page after the last step, how many conditions of each
    /// step were met.
    void showPage(const LessonPage& page, const QList<LessonMark>& marks);
    void showLessons();
    /// Removes everything that leads to files and to other lessons.
    void lock();

    void setPlaying(bool isPlaying);
    void setProgress(double share); ///< fraction of the teacher's strokes that have been played, 0 to 1
    /// Shows which conditions are met; an empty list shows none. `areOfPresent`: false if the model has changed since
    /// the marks were determined; they are then shown disabled.
    void setMarks(const QList<LessonMark>& marks, bool areOfPresent = true);
    bool wantsDifference() const;

    /// Returns the displayed step; nullopt: no lesson is open. changed() is emitted when it changes.
    const std::optional<LessonPanelState>& shown() const { return m_shown; }
    /// Acts as if a button were pressed; ignored if the button is disabled or no lesson is open.
    void press(LessonButton button);

Q_SIGNALS:
    void changed();
    void lessonChosen(const QString& name);
    void fileRequested();
    void stepRequested(int step);
    void playRequested(bool on);
    void singleStrokeRequested(); ///< the teacher's next stroke is to be played, then playback stops
    void speedChosen(double speed);
    void tryRequested();
    /// The step is to begin with the teacher's model instead of the pupil's.
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
    QList<QWidget*> m_waysOut; ///< buttons that lead to files and to other lessons
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

/// Adds the panel to the column; the action help.lessons opens it.
void addLessonPanel(SideColumn* column, const Actions& actions);
} // namespace ui
