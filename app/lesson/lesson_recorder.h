#pragma once

#include "core/lesson/lesson_draft.h"

#include <QObject>

#include <functional>

namespace app
{
class Document;

/// Writes what is done to the document, by whatever hand, into the last step of a lesson, in step with the undo stack:
/// what is undone is out of the lesson, what is redone in it again. Thread: gui.
class LessonRecorder : public QObject
{
    Q_OBJECT

public:
    /// The document must outlive it.
    explicit LessonRecorder(Document& document);

    bool isOn() const { return m_draft != nullptr; }
    /// The document has just come, as the draft's steps leave it, of which there is one at least. What is done to the
    /// draft meanwhile leaves the order of its steps and their strokes as they are; it must live until end(). `view`:
    /// from where the teacher looks at the model.
    void begin(core::LessonDraft* draft, std::function<std::optional<core::LessonView>()> view);
    void end();

Q_SIGNALS:
    /// The draft has other strokes.
    void recorded();
    /// Nothing is recorded any more: the history has gone, or the model.
    void ended();
    /// A step that no lesson can hold was undone: it needs a file.
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
    core::LessonDraft* m_draft = nullptr; ///< null: off
    std::function<std::optional<core::LessonView>()> m_view;
    std::vector<std::size_t> m_steps; ///< of what is on the undo stack and done
    std::vector<Undone> m_undone;     ///< the next one last
};
} // namespace app
