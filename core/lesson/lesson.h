#pragma once

#include "core/io/stroke/stroke_file.h"
#include "core/lesson/checkpoint.h"
#include "core/primitives/starter_models.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace core
{
/// One text in several languages. Language codes are like "de", "zh" or "pt_BR".
struct LessonText
{
    std::map<std::string, std::string, std::less<>> words; ///< the text in each language, by language code

    /// Returns the text in that language. If it is missing, tries the language without its country ("de" for "de_AT"),
    /// then English, then the first language. Returns an empty text if there is none.
    const std::string& in(std::string_view language) const;
};

/// The direction from which a step is viewed, in degrees. 0, 0 is level from the front; positive yaw views from the
/// right, positive pitch from above.
struct LessonView
{
    double yaw = 0;   ///< degrees, -180 to 180
    double pitch = 0; ///< degrees, -90 to 90

    friend bool operator==(const LessonView&, const LessonView&) = default;
};

/// A tool with the brush that the teacher uses first.
struct LessonBrush
{
    Tool tool = Tool::Pull;
    double radius = 0; ///< mm
    double strength = 1;
};

/// One step of a lesson: explained in text, demonstrated by strokes, tried by the pupil, and checked at its end.
struct LessonStep
{
    LessonText title, text;
    std::string picture;     ///< name in Lesson::files; empty: no picture
    std::vector<Tool> tools; ///< tools that the pupil may use; empty: all
    std::optional<LessonView> view;
    std::string strokesFile; ///< file of the teacher's strokes; empty: none
    /// The teacher's strokes. They need no other files: alphas are built in, stamps are balls, and nothing is inserted.
    std::vector<FileEntry> strokes;
    Checkpoint checkpoint;
};

/// Returns the tools of the step's strokes in order of first use, each with its first brush.
std::vector<LessonBrush> brushesOf(const LessonStep& step);

/// A lesson: a start model and the steps that build on it. Teachers write lessons, pupils play them; lesson_file.h
/// describes the file.
struct Lesson
{
    LessonText title, summary;
    std::variant<Starter, std::string> start = Starter::Ball; ///< a starter model, or a name in `files`
    std::vector<LessonStep> steps;
    std::map<std::string, std::string> files; ///< content of pictures and models, by their names in the lesson
};
} // namespace core
