#pragma once

#include "core/lesson/lesson_draft.h"

#include <QObject>

#include <functional>

namespace app
{
class Document;

/// Records the strokes and commands made in the document into the last step of a lesson. It follows the undo stack:
/// undoing removes a stroke from the lesson, redoing adds it again. Thread: gui.
class LessonRecorder : public QObject
{
    Q_OBJECT

public:
    /// The document must outlive it.
    explicit LessonRecorder(Document& document);

    bool isOn() const { return m_draft != nullptr; }
    /// Starts recording. Preconditions: the document has just been opened with the result of the draft's steps, the
    /// draft has a step, and it lives until end(). Until then, the order of its steps and strokes must not be changed
    /// otherwise. `view`: returns the teacher's present view of the model.
    void begin(core::LessonDraft* draft, std::function<std::optional<core::LessonView>()> view);
    void end();

Q_SIGNALS:
    /// Emitted when the draft's strokes have changed.
    void recorded();
    /// Emitted when recording has ended, because the history was cleared or another model was opened.
    void ended();
    /// Emitted when a step was undone because it needs a file, which a lesson cannot contain.
    void refused();

private:
    struct Undone
    {
        core::FileEntry entry;
        std::size_t step;
    };

    void add(const core::FileEntry& entry);
    void onIndexChanged(int index);
    void removeLast();
    void refuseUnfit();

    Document* m_document;
    core::LessonDraft* m_draft = nullptr; ///< null: not recording
    std::function<std::optional<core::LessonView>()> m_view;
    std::vector<std::size_t> m_steps; ///< lesson step of each entry of the undo stack in effect
    std::vector<Undone> m_undone;     ///< undone strokes; the next one to redo is last
};
} // namespace app
