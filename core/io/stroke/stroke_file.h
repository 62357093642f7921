#pragma once

#include "core/geometry/lattice.h"
#include "core/operations/model_command.h"
#include "core/stroke/stroke.h"

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace core
{
/// The stroke file: what `replay` plays, and the form of records and lessons. JSON; lengths in the document's unit.
///
///     {"format":"fettle-strokes","version":1,"strokes":[
///       {"tool":"pull","brush":"sphere","radius":0.25,"strength":1.0,"falloff":4,"detail":1.0,"topology":"adaptive",
///        "fusion":true,"symmetry":"none","radial":1,"spacing":0,"place":"point","add":false,"turntable_deg_per_s":0,
///        "samples":[{"t":0,"position":[1,0,0],"direction":[-1,0,0],"pressure":1,"rotation":[0,0,0,1],
///                    "radius":0.25,"strength":1}]}]}
///
/// Required: format, version, strokes, and in a stroke tool, radius and samples, and in a sample position; with
/// "place":"ray" also direction. The rest has the defaults above (time: 0; a sample's radius and strength: the
/// stroke's). A stroke may have "airbrush": StrokeSettings::airbrush, "join": StrokeSettings::join, and "anchored":
/// StrokeSettings::anchored. "topology" is refine, adaptive, keep or uniform (core::Topology).
///
/// A stroke may have "alpha": a name of builtInAlphas(), or an image's path; "alpha_follows": true; "model": a model's
/// path. A path is absolute or starts from the stroke file. Records have "alpha_hash" and "model_hash", too:
/// fingerprints of what was used.
///
/// Between strokes may stand commands for the whole model (model_command.h):
///
///     {"command":"move","by":[1,0,0]}                     {"command":"mirror","plane":"x"}
///     {"command":"rotate","rotation":[0,0,0,1]}           {"command":"symmetrize","plane":"x","keep":"positive"}
///     {"command":"scale","factor":2}                      {"command":"recentre"}
///     {"command":"fill","color":[200,120,80]}             {"command":"remesh","detail_length":0.1}
///     {"command":"insert","file":"a.stl","where":"centre","centre":[0,3,0]}
///
/// "keep": positive (the default) or negative. Without "detail_length": 4/3 of the mean edge. "where": beside (the
/// default), as_it_is, or centre, and only then with "centre". "recenter" and "center" are taken as well.
struct StrokeFileError : std::runtime_error
{
    enum class Kind {
        CannotRead, ///< no such file, or not readable
        TooLarge,   ///< longer than the reader takes, `most` bytes
        Syntax,     ///< not JSON; `line`, `byte` say where
        DuplicateKey,
        NotStrokes,   ///< JSON, but not of this format or version
        NotBrush,     ///< JSON, but no preset file (brush_file.h)
        NewerVersion, ///< a preset file that was made by a newer program
        UnknownKey,
        MissingKey,
        WrongType,
        UnknownValue, ///< a word that the format does not have
        NotANumber,   ///< NaN or infinite, or too large for a double
        OutOfRange
    };

    /// Says what a key holds.
    enum class Value {
        Number,
        WholeNumber,
        ThreeNumbers,
        FourNumbers,
        ThreeBytes, ///< whole numbers from 0 to 255
        TrueOrFalse,
        Word,
        WordOrTruth, ///< a word, true or false
        Object,
        Objects ///< a list of them
    };

    explicit StrokeFileError(Kind errorKind, std::string keyName = {});

    Kind kind;
    std::string key;                   ///< the key, or key and value ("tool": "melt"), in question; may be empty
    std::optional<std::size_t> stroke; ///< or command, counted from 0
    std::optional<std::size_t> sample; ///< counted from 0, in its stroke
    std::size_t line = 0;              ///< counted from 1; 0: unknown
    std::size_t byte = 0;              ///< counted from 1; 0: unknown
    std::optional<double> min, max;    ///< with OutOfRange, where there is a range
    bool orZero = false;               ///< with OutOfRange: 0 is taken, too
    std::vector<std::string> words;    ///< with UnknownValue: the words that the key has; empty: it may be any word
    std::optional<Value> wanted;       ///< with WrongType
    std::optional<double> version;     ///< with NotStrokes: the version of the file, if it has another one
    int systemError = 0;               ///< errno, with CannotRead, where it is known
};

struct FileCommand
{
    ModelCommand command;
    std::string file; ///< of an Insert: where its model is; whoever plays the file reads it into the command
};
using FileEntry = std::variant<Stroke, FileCommand>;

/// Throws StrokeFileError. Cost: linear in the text's length, whatever it holds.
std::vector<FileEntry> parseStrokes(std::string_view text);
std::vector<FileEntry> readStrokes(const std::string& path);
/// Returns the bytes of a file or pipe. Throws StrokeFileError: CannotRead, or TooLarge.
std::string readStrokeText(const std::string& path, std::size_t maxBytes);

/// Checks that the model's lattice holds the stroke's brushes and that the hands are within the working volume; a ray
/// may come from anywhere. Throws StrokeFileError::OutOfRange, with the sample. `offset`: of the document's origin in
/// the file's coordinates, in which ranges are told; with one, a position is refused by its first coordinate that is
/// out of range, as position[0].
void requireFit(const Stroke& stroke, const Lattice& lattice, const Vec3& offset = Vec3::Zero());

/// Writes every key, and numbers with enough digits to come back bit-identical.
void writeStrokes(std::ostream& out, const std::vector<FileEntry>& entries);
} // namespace core
