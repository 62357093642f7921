#pragma once

#include "app/lesson/lesson_autosave.h"
#include "app/lesson/lesson_recorder.h"
#include "app/lesson/lesson_writer.h"

#include "core/primitives/starter_models.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/util/background_thread.h"

#include <QPointer>

#include <functional>

namespace ui
{
class MainWindow;
}

namespace app
{
class Document;

/// Edits a lesson in the window: records steps from the document, changes them, and checks and writes the lesson.
/// Thread: gui.
class LessonEditorController : public QObject
{
    Q_OBJECT

public:
    /// A child of the document. The document must outlive it; the window need not.
    LessonEditorController(ui::MainWindow& window, Document& document);

    /// Autosaves unsaved lessons to `root`, and offers those of earlier runs. Must be called once.
    void enableAutosave(const std::filesystem::path& root);

private:
    void start(const std::optional<core::Starter>& starter);
    void startFromModel();
    void read(const QString& pathOrName);
    void resumeUnsaved(const QString& unsaved);
    void showLessons();
    void setLesson(core::Lesson lesson, const QString& path);
    void record(bool on);
    void openAtEnd(bool discardsChanges, bool isUnsaved = false);
    void begin();
    void stopRecording();
    void addFacts();
    void leave();
    bool hasChanges() const;
    /// Calls `then` at once if nothing is unsaved, or when the user agrees to discard the changes. Does not call it if
    /// the user saves or cancels.
    void confirmDiscard(std::function<void()> then);

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonEditor> m_panel;
    Document* m_document;
    core::LessonDraft m_draft;
    LessonRecorder m_recorder;
    LessonWriter m_writer;
    QString m_path;              ///< file of the lesson that was opened or written last; empty: none
    std::uint64_t m_written = 0; ///< revision of the draft that was written last
    /// lesson whose end is being opened for recording; null: none
    std::shared_ptr<const core::Lesson> m_opening;
    bool m_isAllRecorded = false;               ///< whether the lesson contains all steps of the document
    std::unique_ptr<LessonAutosave> m_autosave; ///< null: autosave is disabled
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
