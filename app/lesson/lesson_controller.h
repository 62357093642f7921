#pragma once

#include "app/lesson/handout_saving.h"
#include "app/lesson/lesson_checker.h"
#include "app/lesson/lesson_progress.h"
#include "app/lesson/lesson_teacher.h"
#include "app/lesson/step_brushes.h"

#include "ui/lesson/lesson_panel.h"
#include "ui/util/background_thread.h"

#include <QPointer>

namespace ui
{
class MainWindow;
}

namespace app
{
/// Gives lessons in the window: opens them with their start as the document, goes from step to step, and shows what the
/// checkpoint finds. Thread: gui.
class LessonController : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it but for the window: a child of the document.
    LessonController(ui::MainWindow& window, Document& document);

    /// Begins a lesson with the model that is open, or goes on with it at a later step.
    void start(const LessonPlace& place);
    /// Returns where the lesson is; nothing if none is open.
    std::optional<LessonPlace> place() const;
    /// Stops the teacher. Returns where the lesson is; nothing if none is open.
    std::optional<LessonPlace> stop();
    /// Ends the lesson, if there is one: the model stays, and the brush is the pupil's own.
    void leave();

private:
    void addToStartPage(const QList<ui::LessonCard>& lessons);
    void read(const QString& pathOrName);
    void openLesson(std::shared_ptr<const core::Lesson> lesson, const std::filesystem::path& path);
    void begin();
    void goTo(int step);
    void goOn(std::size_t step);
    void show();
    void showEnd();
    void showVerdict(const core::CheckpointVerdict& verdict, const std::shared_ptr<const core::Footprint>& shades);
    void keepMarks();
    QList<ui::LessonMark> marksOf(const core::CheckpointVerdict& verdict);
    void shade();

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonPanel> m_panel;
    Document* m_document;
    LessonChecker* m_checker;
    LessonTeacher m_teacher;
    StepBrushes m_brushes;
    LessonProgress m_progress;
    HandoutSaving m_handout;
    bool m_isAtEnd = false;      ///< the page after the last step is shown
    std::optional<bool> m_isMet; ///< the step's checkpoint, by the model as it was last judged
    std::shared_ptr<const core::Lesson> m_lesson, m_opening; ///< null: none
    std::filesystem::path m_path, m_openingPath;
    std::shared_ptr<const core::Footprint> m_shades;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
