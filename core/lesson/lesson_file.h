#pragma once

#include "core/analysis/mesh_check.h"
#include "core/lesson/lesson.h"
#include "core/util/file_error.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace core
{
/// The format of a lesson: a folder, or a zip of it, that contains lesson.json:
///
///     {"format":"fettle-lesson","version":1,
///      "title":{"en":"First clay","de":"Der erste Ton"},"summary":{"en":"..."},
///      "start":"ball",
///      "steps":[
///        {"title":{"en":"Pull"},"text":{"en":"..."},"picture":"pull.png","tools":["pull","smooth"],
///         "view":{"yaw_deg":30,"pitch_deg":20},"strokes":"pull.json",
///         "checkpoint":{"genus":1,"height_mm":{"least":60},"print_ready":true,"target":{"tolerance_mm":4}}}]}
///
/// Required keys: format, version, title, start and steps; in a step: title and text. Texts are objects with one text
/// for each language; LessonText says what replaces a missing language. "start" is the name of a starter
/// (starter_models.h), or {"file":"start.stl"}. "picture" is a PNG or JPEG. "view" is a LessonView, the direction from
/// which the step is viewed. "strokes" is a stroke file (stroke_file.h) that needs no other file. "tools" are named as
/// in stroke files. "checkpoint" contains facts by their keys in factTable. A fact's value is a number, or an object
/// with "least", "most" or both; for "print_ready" it is true. "target" is {"file":"target.stl","tolerance_mm":2};
/// without a file the target is the result of the step's strokes. File paths are relative to lesson.json, use "/", and
/// must not leave its folder.
struct LessonError : std::runtime_error
{
    enum class Kind {
        NoLesson,   ///< the folder or zip contains no lesson.json
        NotALesson, ///< lesson.json states no format, or another format
        Newer,      ///< written by a newer program; `version` is the file's version
        Syntax,     ///< not JSON; `line` and `byte` give the place
        TooDeep,    ///< brackets are nested too deeply
        DuplicateKey,
        UnknownKey,
        MissingKey,
        WrongType,
        UnknownValue, ///< a keyword that the format does not define
        OutOfRange,   ///< a number outside `min` to `max`
        NoWords,      ///< a text is empty
        TooLong,      ///< a text is longer than `max` bytes
        TooMany,      ///< more than `max` steps or files
        BadName,      ///< the file name in `key` leaves the folder or has forbidden characters
        MissingFile,  ///< `file` is referenced but does not exist
        TooLarge,     ///< `file`, or all files together if it is empty, has more than `max` bytes
        NotAPicture,  ///< `file` is neither PNG nor JPEG
        /// The model in `file` does not bound a solid, and `report` has the reason; or `max` of its faces cannot be
        /// fitted to the lattice.
        Unsound,
        Strokes,    ///< `strokes` has the error in `file`
        NamesFiles, ///< a stroke in `file` needs another file; `strokes` has its index
        Refused,    ///< a command in `file` would make the model invalid; `strokes` has its index
    };

    LessonError(Kind errorKind, std::filesystem::path lesson);

    Kind kind;
    std::filesystem::path path;      ///< path of the lesson
    std::string file;                ///< file in the lesson; empty: lesson.json
    std::optional<std::size_t> step; ///< index of the step, from 0
    std::string key;                 ///< key, value or name at fault; may be empty
    std::size_t line = 0, byte = 0;  ///< counted from 1; 0: unknown
    double min = 0, max = 0;
    std::uint64_t version = 0;
    std::optional<StrokeFileError> strokes;
    MeshReport report = {};
};

/// Limits for lessons from an untrusted source, in bytes unless a name says otherwise.
struct LessonLimits
{
    /// Total size of all files in bytes, packed or unpacked.
    static constexpr std::size_t maxBytes = std::size_t(64) << 20;
    static constexpr std::size_t maxJsonBytes = std::size_t(1) << 20, maxStrokeBytes = std::size_t(16) << 20,
                                 maxPictureBytes = std::size_t(4) << 20;
    static constexpr std::size_t maxSteps = 200, maxPackedFiles = 2000, maxTextBytes = 8000, maxNameBytes = 120;
};

/// The source of a lesson's files. `read` returns the content of the file with that name, or nothing if it does not
/// exist. For a file larger than `max` bytes it returns any `max` + 1 bytes.
struct LessonFiles
{
    std::filesystem::path path; ///< path of the lesson, for errors
    std::function<std::optional<std::string>(const std::string& name, std::size_t max)> read;
};

/// Reads a lesson. Throws LessonError; also FileError if a file, the zip or a model is damaged. The result is complete:
/// every referenced file was found and parsed. Cost: linear in the files; start models and targets are checked with
/// checkMesh().
Lesson readLesson(const LessonFiles& files);
/// Reads a lesson from a folder or a zip. In a zip the lesson may be in a folder of its own.
Lesson readLesson(const std::filesystem::path& path);

/// Writes the lesson: as a zip if the path ends in .zip, else as a new folder. Throws FileError; the disk is then
/// unchanged. Reading the files returns an identical lesson.
void writeLesson(const std::filesystem::path& path, const Lesson& lesson);

/// Returns the content of all files that writeLesson() writes, by name.
std::map<std::string, std::string> filesOf(const Lesson& lesson);
/// Returns the text of lesson.json.
std::string lessonJson(const Lesson& lesson);
/// Returns the text of the step's stroke file.
std::string strokesText(const LessonStep& step);

/// Parses a model from the lesson's files. Throws FileError.
TriangleMesh modelIn(const Lesson& lesson, const std::string& file);
} // namespace core
