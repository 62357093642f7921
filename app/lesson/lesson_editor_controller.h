#pragma once

#include "app/lesson/lesson_autosave.h"
#include "app/lesson/lesson_recorder.h"
#include "app/lesson/lesson_writer.h"

#include "core/operations/starter_models.h"
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

/// Edits a teacher's lesson in the window: records it from the document, changes, checks and writes it. Thread: gui.
class LessonEditorController : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it but for the window: a child of the document.
    LessonEditorController(ui::MainWindow& window, Document& document);

    /// Autosaves unsaved lessons there, and offers those that earlier runs left. To be called once.
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
    /// Calls `then` at once, or when the user agrees to discard the changes; not if the user saves instead.
    void confirmDiscard(std::function<void()> then);

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonEditor> m_panel;
    Document* m_document;
    core::LessonDraft m_draft;
    LessonRecorder m_recorder;
    LessonWriter m_writer;
    QString m_path;              ///< of the lesson that was opened, or where it was written; empty: neither
    std::uint64_t m_written = 0; ///< revision of the draft that is in a file
    /// At whose end recording begins once its model is there; null: none.
    std::shared_ptr<const core::Lesson> m_opening;
    bool m_isAllRecorded = false;               ///< all steps of the document are in the lesson
    std::unique_ptr<LessonAutosave> m_autosave; ///< null: off
    ui::BackgroundThread m_background;          ///< last
};
} // namespace app
