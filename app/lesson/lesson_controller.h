#pragma once

#include "app/lesson/lesson_checker.h"

#include "core/lesson/lesson_player.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/util/background_thread.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

namespace ui
{
class MainWindow;
}

namespace app
{
/// Gives a lesson in the window: its start is the document, the teacher's strokes are steps to undo, and what the pupil
/// does is the pupil's own. A stroke of the hand ends the teacher's. Gui thread.
class LessonController : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it but for the window: a child of the document.
    LessonController(ui::MainWindow& window, Document& document, SculptWorker& worker);

private:
    void addToStartPage(const QList<ui::LessonCard>& lessons);
    void read(const QString& pathOrName);
    void openLesson(std::shared_ptr<const core::Lesson> lesson, const std::filesystem::path& path);
    void begin();
    void leave();
    void enter(std::size_t step);
    void goTo(int step);
    void show();
    void playOrPause(bool on);
    void playOne();
    void beTaught();
    void setPlaying(bool isPlaying);
    void tryIt();
    void interrupt();
    void onStrokeRefused();
    void endStroke();
    void tick();
    void run(const core::LessonCue& cue);
    bool isBehind() const;
    void placeGhost();
    void showGhost(const std::optional<core::Sphere>& ghost);
    void showVerdict(const core::CheckpointVerdict& verdict, const std::shared_ptr<const core::Footprint>& shades);
    void shade();

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonPanel> m_panel;
    Document* m_document;
    SculptWorker* m_worker;
    LessonChecker* m_checker;
    std::shared_ptr<const core::Lesson> m_lesson, m_opening; ///< null: none
    std::filesystem::path m_path, m_openingPath;
    std::optional<core::LessonPlayer> m_player; ///< while a lesson is open
    std::vector<int> m_starts;                  ///< on the undo stack, of the steps up to this one
    bool m_isTaught = false;                    ///< the teacher is in the middle of the step
    bool m_isStrokeOpen = false;                ///< the teacher's
    bool m_isCounted = false;                   ///< the stroke's samples are all consumed: it adds nothing
    quint64 m_posted = 0, m_consumedBefore = 0; ///< the stroke's samples
    bool m_isGhostAsked = false;
    double m_speed = 1;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    std::shared_ptr<const core::Footprint> m_shades;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
