#pragma once

#include "core/lesson/lesson.h"

#include <optional>
#include <string_view>

namespace core
{
/// A lesson in the making. Steps are counted from 0; those that are named are there.
class LessonDraft
{
public:
    explicit LessonDraft(Lesson lesson = {}) : m_lesson(std::move(lesson)) {}

    const Lesson& lesson() const { return m_lesson; }
    const LessonStep& step(std::size_t index) const { return m_lesson.steps[index]; }
    std::size_t steps() const { return m_lesson.steps.size(); }
    std::size_t strokes() const; ///< of all steps; commands count, too
    /// Grows with each change.
    std::uint64_t revision() const { return m_revision; }

    // Words: spaces alone are none, and take the language away.
    void setTitle(const std::string& language, std::string_view words);
    void setSummary(const std::string& language, std::string_view words);
    void setStepTitle(std::size_t step, const std::string& language, std::string_view words);
    void setStepText(std::size_t step, const std::string& language, std::string_view words);

    /// As the last one.
    void addStep();
    void removeStep(std::size_t step);
    void moveStep(std::size_t from, std::size_t to);

    /// In the order of Tool, each once; all or none: the pupil may use any.
    void setTools(std::size_t step, std::vector<Tool> tools);
    /// Its former bounds go; bounds that all models keep are none.
    void setFact(std::size_t step, const FactBounds& bounds);
    std::optional<FactBounds> fact(std::size_t step, Fact fact) const;
    /// mm; 0: no shape is asked for. The file of the shape stays, if there is one.
    void setTolerance(std::size_t step, double tolerance);

    /// The view of its first stroke is the step's.
    void addStroke(std::size_t step, FileEntry entry, const std::optional<LessonView>& view = {});
    /// The step has one.
    FileEntry takeLastStroke(std::size_t step);
    void cutStroke(std::size_t step, std::size_t stroke);

    /// What must be there before it can be written.
    enum class Required { Title, Steps, StepTitle, StepText };
    struct Missing
    {
        Required what;
        std::size_t step = 0; ///< of StepTitle and StepText
    };
    /// The first of it; nothing: complete() can be written.
    std::optional<Missing> missing() const;

    /// Whether the step's picture is to be made of what its strokes leave: it has none, or one that was made so.
    /// Pictures under any other name are somebody's own, and stay.
    bool makesPicture(std::size_t step) const;
    /// As it is written: each step's strokes in a file of their own, the pictures (PNG, by steps; empty: none) where
    /// makesPicture() wants them, and no file that nothing names.
    Lesson complete(const std::vector<std::string>& pictures) const;

private:
    void setWords(LessonText& text, const std::string& language, std::string_view words);
    LessonStep& change(std::size_t step);

    Lesson m_lesson;
    std::uint64_t m_revision = 0;
};
} // namespace core
