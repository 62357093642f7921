#pragma once

#include "core/lesson/lesson.h"

#include <optional>
#include <string_view>

namespace core
{
/// A lesson that is being written. Steps are numbered from 0. Precondition of all functions: the given step exists.
class LessonDraft
{
public:
    explicit LessonDraft(Lesson lesson = {}) : m_lesson(std::move(lesson)) {}

    const Lesson& lesson() const { return m_lesson; }
    const LessonStep& step(std::size_t index) const { return m_lesson.steps[index]; }
    std::size_t steps() const { return m_lesson.steps.size(); }
    std::size_t strokes() const; ///< strokes and commands of all steps together
    /// Returns a number that grows with each change.
    std::uint64_t revision() const { return m_revision; }

    // A text of only white space removes the language.
    void setTitle(const std::string& language, std::string_view words);
    void setSummary(const std::string& language, std::string_view words);
    void setStepTitle(std::size_t step, const std::string& language, std::string_view words);
    void setStepText(std::size_t step, const std::string& language, std::string_view words);

    /// Appends an empty step.
    void addStep();
    void removeStep(std::size_t step);
    void moveStep(std::size_t from, std::size_t to);

    /// Sets the tools that the pupil may use, and sorts them. With all tools or none, every tool is allowed.
    /// Precondition: no tool is listed twice.
    void setTools(std::size_t step, std::vector<Tool> tools);
    /// Replaces the bounds of this fact. Bounds that every model satisfies are removed.
    void setFact(std::size_t step, const FactBounds& bounds);
    std::optional<FactBounds> fact(std::size_t step, Fact fact) const;
    /// Sets the target's tolerance in mm; 0 removes the target. An existing target keeps its file.
    void setTolerance(std::size_t step, double tolerance);

    /// Appends a stroke. The first stroke's view becomes the view of the step.
    void addStroke(std::size_t step, FileEntry entry, const std::optional<LessonView>& view = {});
    /// Removes the step's last stroke and returns it. Precondition: the step has a stroke.
    FileEntry takeLastStroke(std::size_t step);
    void cutStroke(std::size_t step, std::size_t stroke);

    /// The parts that a lesson must have before it can be written.
    enum class Required { Title, Steps, StepTitle, StepText };
    struct Missing
    {
        Required what;
        std::size_t step = 0; ///< only for StepTitle and StepText
    };
    /// Returns the first part that is missing; nothing if complete() can be written.
    std::optional<Missing> missing() const;

    /// Returns whether the step's picture is generated from the result of its strokes: it has no picture, or one that
    /// complete() named. Pictures with any other name are the author's own and are kept.
    bool makesPicture(std::size_t step) const;
    /// Returns the lesson as it is written. Each step's strokes get a file of their own; files that nothing references
    /// are removed. `pictures`: one PNG for each step, used where makesPicture() is true; empty: no picture.
    Lesson complete(const std::vector<std::string>& pictures) const;

private:
    void setWords(LessonText& text, const std::string& language, std::string_view words);
    LessonStep& change(std::size_t step);

    Lesson m_lesson;
    std::uint64_t m_revision = 0;
};
} // namespace core
