#pragma once

#include <QObject>
#include <QPointer>

#include <cstdint>
#include <memory>
#include <optional>

namespace core
{
struct Lesson;
class LessonDraft;
} // namespace core
namespace ui
{
class MainWindow;
}

namespace app
{
class Document;
class LessonRecorder;
struct CheckedLesson;

/// Writes the edited lesson. First plays it to its end, and asks the user whether to continue if it has defects, such
/// as unmet goals. Thread: gui; lessons are played and written on a background thread.
class LessonWriter : public QObject
{
    Q_OBJECT

public:
    /// Owns none of the arguments; all must outlive this, except the window.
    LessonWriter(ui::MainWindow& window, Document& document, const core::LessonDraft* draft,
                 const LessonRecorder* recorder);

    /// Asks for a file and saves the lesson. `path`: file that the lesson was read from or written to before.
    void save(const QString& path);

Q_SIGNALS:
    /// Emitted when this revision of the draft was written to the file.
    void written(const QString& path, std::uint64_t revision);

private:
    void check(const QString& path, const core::LessonDraft& draft, const std::optional<std::uint64_t>& hash);
    void onChecked(const QString& path, const CheckedLesson& checked, std::uint64_t revision);
    void write(const QString& path, const std::shared_ptr<const core::Lesson>& lesson, std::uint64_t revision);

    QPointer<ui::MainWindow> m_window;
    Document* m_document;
    const core::LessonDraft* m_draft;
    const LessonRecorder* m_recorder;
};
} // namespace app
