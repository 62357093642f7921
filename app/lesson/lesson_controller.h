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
/// Gives lessons in the window: opens a lesson's start as the document, moves from step to step, and shows the result
/// of each checkpoint. Thread: gui.
class LessonController : public QObject
{
    Q_OBJECT

public:
    /// A child of the document. The document must outlive it; the window need not.
    LessonController(ui::MainWindow& window, Document& document);

    /// Begins a lesson with the open model, or continues it at a later step.
    void start(const LessonPlace& place);
    /// Returns the present place in the lesson; nothing if no lesson is open.
    std::optional<LessonPlace> place() const;
    /// Stops the demonstration. Returns the present place in the lesson; nothing if no lesson is open.
    std::optional<LessonPlace> stop();
    /// Ends the open lesson, if there is one. The model stays, and the pupil's own brush settings are restored.
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
    bool m_isAtEnd = false;      ///< whether the page after the last step is shown
    std::optional<bool> m_isMet; ///< whether the model met the checkpoint when last measured; nothing: not measured
    /// the open lesson, and the lesson whose model is being opened; null: none
    std::shared_ptr<const core::Lesson> m_lesson, m_opening;
    std::filesystem::path m_path, m_openingPath;
    std::shared_ptr<const core::Footprint> m_shades;
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
