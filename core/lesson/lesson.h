#pragma once

#include "core/io/stroke/stroke_file.h"
#include "core/lesson/checkpoint.h"
#include "core/operations/starter_models.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace core
{
/// The same words in several languages. Codes as "de", "zh" or "pt_BR".
struct LessonText
{
    std::map<std::string, std::string, std::less<>> words; ///< by code

    /// In that language, else without its country ("de" for "de_AT"), else in English, else in the first that there is.
    /// Empty if there is none.
    const std::string& in(std::string_view language) const;
};

/// Direction that a step is seen from, degrees. 0, 0: the front, level; yaw above 0 from the right, pitch from above.
struct LessonView
{
    double yaw = 0;   ///< -180 to 180
    double pitch = 0; ///< -90 to 90

    friend bool operator==(const LessonView&, const LessonView&) = default;
};

/// A tool, and the brush that the teacher takes it up with.
struct LessonBrush
{
    Tool tool = Tool::Pull;
    double radius = 0; ///< mm
    double strength = 1;
};

/// What is explained, shown, tried and checked at once.
struct LessonStep
{
    LessonText title, text;
    std::string picture;     ///< one of Lesson::files; empty: none
    std::vector<Tool> tools; ///< that the pupil may use; empty: all
    std::optional<LessonView> view;
    std::string strokesFile; ///< that holds the strokes; empty: there are none
    /// The teacher's. They need no files: alphas are built in, stamps balls, nothing is inserted.
    std::vector<FileEntry> strokes;
    Checkpoint checkpoint;
};

/// Returns the tools of the step's strokes, each with its first brush, in order.
std::vector<LessonBrush> brushesOf(const LessonStep& step);

/// A lesson: a model to begin with, and steps from there. What teachers write, and pupils play: see lesson_file.h.
struct Lesson
{
    LessonText title, summary;
    std::variant<Starter, std::string> start = Starter::Ball; ///< or one of `files`
    std::vector<LessonStep> steps;
    std::map<std::string, std::string> files; ///< pictures and models: what each holds, by the lesson's name for it
};
} // namespace core
