#pragma once

#include "core/analysis/mesh_check.h"
#include "core/lesson/lesson.h"
#include "core/util/file_error.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace core
{
/// A lesson's file is a folder, or one zip of it, with a lesson.json in it:
///
///     {"format":"fettle-lesson","version":1,
///      "title":{"en":"First clay","de":"Der erste Ton"},"summary":{"en":"..."},
///      "start":"ball",
///      "steps":[
///        {"title":{"en":"Pull"},"text":{"en":"..."},"picture":"pull.png","tools":["pull","smooth"],
///         "view":{"yaw_deg":30,"pitch_deg":20},"strokes":"pull.json",
///         "checkpoint":{"genus":1,"height_mm":{"least":60},"print_ready":true,"target":{"tolerance_mm":4}}}]}
///
/// Required: format, version, title, start, steps, and in a step title and text. Texts are words by language; where a
/// language is missing see LessonText. "start": the name of a starter (starter_models.h), or {"file":"start.stl"}.
/// "picture": PNG or JPEG. "view": LessonView, from where the step is looked at. "strokes": a stroke file
/// (stroke_file.h) that needs no other file. "tools": by their names in stroke files. "checkpoint": facts by the keys
/// of factTable, a number, or least and most, or either of them; "print_ready" is true; "target":
/// {"file":"target.stl","tolerance_mm":2}, and without a file what the step's strokes leave. Files are named by their
/// way from lesson.json, with "/", and do not leave its folder.
struct LessonError : std::runtime_error
{
    enum class Kind {
        NoLesson,   ///< no lesson.json in it
        NotALesson, ///< lesson.json is of no, or of another format
        Newer,      ///< `version`
        Syntax,     ///< not JSON; `line`, `byte` say where
        TooDeep,    ///< brackets in brackets in brackets
        DuplicateKey,
        UnknownKey,
        MissingKey,
        WrongType,
        UnknownValue, ///< a word that the format does not have
        OutOfRange,   ///< `least`, `most`
        NoWords,      ///< a text that is empty
        TooLong,      ///< a text; `most` bytes
        TooMany,      ///< steps, or files; `most`
        BadName,      ///< of a file: it leaves the folder, or is not plain; `key` holds it
        MissingFile,  ///< `file` is named, but not there
        TooLarge,     ///< `file`, or all together if it is empty; `most` bytes
        NotAPicture,  ///< `file` is neither PNG nor JPEG
        /// The model in `file` bounds no solid: `report` says why; or else `most` of its faces fit no lattice.
        Unsound,
        Strokes,    ///< `strokes` says what is wrong in `file`
        NamesFiles, ///< strokes in `file` need other files; `strokes` says which
        Refused,    ///< a command in `file` cannot be done soundly; `strokes` says which
    };

    LessonError(Kind errorKind, std::filesystem::path lesson);

    Kind kind;
    std::filesystem::path path;      ///< the lesson's
    std::string file;                ///< in it; empty: lesson.json
    std::optional<std::size_t> step; ///< counted from 0
    std::string key;                 ///< the key, word or name in question; may be empty
    std::size_t line = 0, byte = 0;  ///< counted from 1; 0: unknown
    double min = 0, max = 0;
    std::uint64_t version = 0;
    std::optional<StrokeFileError> strokes;
    MeshReport report = {};
};

/// So much is taken of a stranger's lesson.
struct LessonLimits
{
    static constexpr std::size_t maxBytes = std::size_t(64) << 20; ///< of all its files; packed and unpacked
    static constexpr std::size_t maxJsonBytes = std::size_t(1) << 20, maxStrokeBytes = std::size_t(16) << 20,
                                 maxPictureBytes = std::size_t(4) << 20;
    static constexpr std::size_t maxSteps = 200, maxPackedFiles = 2000, maxTextBytes = 8000, maxNameBytes = 120;
};

/// Where the files of a lesson come from. `read`: what the file of that name holds, or nothing if there is none; of one
/// that is larger than `most` any `most` + 1 bytes.
struct LessonFiles
{
    std::filesystem::path path; ///< of the lesson, for errors
    std::function<std::optional<std::string>(const std::string& name, std::size_t max)> read;
};

/// Throws LessonError, and FileError where file, zip or model are bad in themselves. What it returns is whole: each
/// file that is named was there and was understood. Cost: linear in the files; starting models and targets are checked
/// (checkMesh).
Lesson readLesson(const LessonFiles& files);
/// Of a folder or a zip. In the zip the lesson may lie in a folder of its own.
Lesson readLesson(const std::filesystem::path& path);

/// As a zip if the name ends so, else as a folder that is not there yet. Throws FileError; then nothing has changed on
/// disk. Read again the lesson is the same to the bit.
void writeLesson(const std::filesystem::path& path, const Lesson& lesson);

/// All files that writeLesson() writes, by their names.
std::map<std::string, std::string> filesOf(const Lesson& lesson);
/// What lesson.json says.
std::string lessonJson(const Lesson& lesson);
/// What the step's stroke file says.
std::string strokesText(const LessonStep& step);

/// The mesh that stands for a model of the lesson's files. Throws FileError.
TriangleMesh modelIn(const Lesson& lesson, const std::string& file);
} // namespace core
