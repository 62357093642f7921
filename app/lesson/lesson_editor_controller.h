#pragma once

#include "app/lesson/lesson_autosave.h"
#include "app/lesson/lesson_recorder.h"
#include "app/lesson/lesson_saving.h"

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
class SculptWorker;

/// A teacher's lesson in the window: recorded from the document, changed, tried and written. Gui thread.
class LessonEditorDesk : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it but for the window: a child of the document.
    LessonEditorDesk(ui::MainWindow& window, Document& document, SculptWorker& worker);

    /// A lesson that is not saved is kept there, and those that are there from before are offered. Once.
    void keepLessons(const std::filesystem::path& root);

private:
    void connectAll();
    void start(const std::optional<core::Starter>& starter);
    void startFromModel();
    void read(const QString& pathOrName);
    void goOnWith(const QString& kept);
    void showLessons();
    void take(core::Lesson lesson, const QString& path);
    void record(bool on);
    void openEnd(bool losesChanges, bool isUnsaved = false);
    void begin();
    void stopRecording();
    void takeFacts();
    void save();
    void attempt(const QString& path, const core::LessonDraft& draft, const std::optional<std::uint64_t>& hash);
    void takeAttempt(const QString& path, const TriedLesson& tried, std::uint64_t revision);
    void write(const QString& path, const std::shared_ptr<const core::Lesson>& lesson, std::uint64_t revision);
    void leave();
    bool hasChanges() const;
    bool mayClose();
    /// `then` at once, or when the person lets the changes go; if they would rather save, it is not done.
    void askThen(std::function<void()> then);

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonEditor> m_panel;
    Document* m_document;
    SculptWorker* m_worker;
    core::LessonDraft m_draft;
    LessonRecorder m_recorder;
    QString m_path;              ///< of the lesson that was opened, or where it was written; empty: neither
    std::uint64_t m_written = 0; ///< revision of the draft that is in a file
    std::shared_ptr<const core::Lesson> m_coming; ///< at whose end recording begins once its model is there; null: none
    bool m_isOurs = false;                        ///< what was done to the document is all in the lesson
    std::unique_ptr<LessonKeeper> m_keeper;       ///< null: nothing is kept
    ui::BackgroundThread m_aside;                 ///< last
};
} // namespace app
