#pragma once

#include "core/geometry/lattice.h"
#include "core/operations/model_command.h"
#include "core/stroke/stroke.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace core
{
/// The stroke file, as JSON: the input of `replay`, and the format of recordings and of a lesson's strokes. Lengths are
/// in the document's unit.
///
///     {"format":"fettle-strokes","version":1,"strokes":[
///       {"tool":"pull","brush":"sphere","radius":0.25,"strength":1.0,"falloff":4,"detail":1.0,"topology":"adaptive",
///        "fusion":true,"symmetry":"none","radial":1,"spacing":0,"place":"point","add":false,"turntable_deg_per_s":0,
///        "samples":[{"t":0,"position":[1,0,0],"direction":[-1,0,0],"pressure":1,"rotation":[0,0,0,1],
///                    "radius":0.25,"strength":1}]}]}
///
/// Required keys: format, version and strokes; in a stroke: tool, radius and samples; in a sample: position, and with
/// "place":"ray" also direction. The other keys default to the values shown above (t: 0; a sample's radius and
/// strength: the stroke's). Optional keys of a stroke are also "airbrush", "join", "anchored", "invert" and
/// "detail_length": see StrokeSettings::airbrush, join, anchored, inverted and detailLength. "topology" is refine,
/// adaptive, keep or uniform (core::Topology).
///
/// More optional keys of a stroke: "alpha", a name in builtInAlphas() or an image's path; "alpha_follows": true;
/// "model", a model's path. A path is absolute or relative to the stroke file's folder. Recordings also have
/// "alpha_hash" and "model_hash", the fingerprints of the files used.
///
/// Commands for the whole model (model_command.h) may be listed between strokes:
///
///     {"command":"move","by":[1,0,0]}                     {"command":"mirror","plane":"x"}
///     {"command":"rotate","rotation":[0,0,0,1]}           {"command":"symmetrize","plane":"x","keep":"positive"}
///     {"command":"scale","factor":2}                      {"command":"recentre"}
///     {"command":"fill","color":[200,120,80]}             {"command":"remesh","detail_length":0.1}
///     {"command":"insert","file":"a.stl","where":"centre","centre":[0,3,0],"combine":"subtract"}
///     {"command":"insert","primitive":"cylinder","radius":2,"height":5,"where":"floor","centre":[0,0,0],"axis":"z"}
///     {"command":"reset"}                                 {"command":"place_on_bed"}
///     {"command":"flatten_base","height":2}               {"command":"mask","how":"invert"}
///     {"command":"edit_part","part":1,"name":"Wheel","locked":false,"tag":[255,0,0],"list_position":0}
///     {"command":"show_parts","parts":[0,1]}              {"command":"duplicate_part","part":1,"name":"Wheel"}
///     {"command":"delete_part","part":1}                  {"command":"separate_part","part":0}
///     {"command":"combine_parts","part":0,"operation":"union","parts":[1]}
///     {"command":"hide","what":"masked"}
///     {"command":"trim","outline":[[0,0,5],[9,0,5],[0,9,5]],"along":[0,0,-1],"eye":[0,0,99],"remove":"inside",
///      "symmetry":"none","front":false}
///     {"command":"mask_area","outline":[[0,0,5],[9,0,5],[0,9,5]],"along":[0,0,-1],"side":"inside","invert":false}
///     {"command":"hide_area","outline":[[0,0,5],[9,0,5],[0,9,5]],"along":[0,0,-1],"side":"inside"}
///     {"command":"split_part","outline":[[0,0,5],[9,0,5],[0,9,5]],"along":[0,0,-1],"side":"inside","name":"Arm"}
///
/// Each stroke and command may have "part", the id of the part that it changes (PartId; default 0). "operation" is
/// union, subtract or intersect; "what" is masked, unmasked or none; "parts" are the parts to show, or to combine
/// with the part. Only "name" of edit_part is required; without "list_position" the part stays in its place.
///
/// "keep" is positive (the default) or negative. "detail_length" defaults to the mesh's own, Mesh::uniformDetail().
/// "how" is one of maskChangeNames (stroke_keys.h); only color needs the key "color". "where" is beside (the default),
/// as_it_is, centre or floor; only the last two need the key "centre". "combine" is apart (the default), join,
/// subtract, intersect or part; only part may have "name". An insertion has either "file" or "primitive", a name of a
/// Primitive::Kind. A primitive needs the keys of its measures, which measuresOf() lists; a lathe needs "profile", a
/// list of pairs [radius, height], a tube "path", a list of [x, y, z, radius]. "edge_length", "axis" (x, y or
/// z; default y) or "along" (a direction in its place), and "symmetry" (mirrors what is inserted) are optional; a tube
/// has no axis. "recenter" and "center" are accepted, too.
/// An area (ViewArea) has "eye" if the view along "along" is a perspective one. The side that is meant is inside (the
/// default) or outside: "remove" of a trim, "side" of the others. "front": only what is seen first (default false).
/// "color" is the colour of the cut. A mask_area with "invert" removes the mask.
struct StrokeFileError : std::runtime_error
{
    enum class Kind {
        CannotRead, ///< the file does not exist or cannot be read
        TooLarge,   ///< longer than the reader accepts; `max` is its limit in bytes
        Syntax,     ///< not JSON; `line` and `byte` give the place
        DuplicateKey,
        NotStrokes,   ///< JSON, but of another format or version
        NotBrush,     ///< JSON, but not a preset file (brush_file.h)
        NewerVersion, ///< a preset file that a newer program wrote
        UnknownKey,
        MissingKey,
        WrongType,
        UnknownValue, ///< a keyword that the format does not define
        NotANumber,   ///< NaN, infinite, or too large for a double
        OutOfRange
    };

    /// The type that a key's value must have.
    enum class Value {
        Number,
        WholeNumber,
        ThreeNumbers,
        FourNumbers,
        ThreeBytes,   ///< three whole numbers from 0 to 255
        WholeNumbers, ///< a list of whole numbers
        TrueOrFalse,
        Word,
        WordOrTruth, ///< a keyword, true or false
        Pairs,       ///< a list of pairs of numbers
        Triples,     ///< a list of lists of three numbers
        Quadruples,  ///< a list of lists of four numbers
        Object,
        Objects ///< a list of objects
    };

    explicit StrokeFileError(Kind errorKind, std::string keyName = {});

    Kind kind;
    std::string key;                   ///< key at fault, or key and value ("tool": "melt"); may be empty
    std::optional<std::size_t> stroke; ///< index of the stroke or command at fault, from 0
    std::optional<std::size_t> sample; ///< index of the sample at fault within its stroke, from 0
    std::size_t line = 0;              ///< counted from 1; 0: unknown
    std::size_t byte = 0;              ///< counted from 1; 0: unknown
    std::optional<double> min, max;    ///< allowed range, if the kind is OutOfRange and there is a range
    bool orZero = false;               ///< true if 0 is allowed in addition to the range
    /// Keywords that the key allows, if the kind is UnknownValue; empty if any text is allowed.
    std::vector<std::string> words;
    std::optional<Value> wanted;   ///< expected type, if the kind is WrongType
    std::optional<double> version; ///< version of the file, if the kind is NotStrokes because of it
    int systemError = 0;           ///< system code (core/util/system_code.h), if the kind is CannotRead; 0 if unknown
};

struct FileCommand
{
    ModelCommand command;
    std::string file; ///< path of an Insert's model, which the file's player must load into `command`
    PartId part = 0;  ///< the part that the command changes, if it concerns one (applyToCopy())
};
using FileEntry = std::variant<Stroke, FileCommand>;

/// Throws StrokeFileError. Cost: linear in the text's length for any content.
std::vector<FileEntry> parseStrokes(std::string_view text);
std::vector<FileEntry> readStrokes(const std::filesystem::path& path);
/// Reads the stream to its end. Precondition: it is binary.
std::vector<FileEntry> readStrokes(std::istream& stream);
/// Returns the bytes of a file or pipe. Throws StrokeFileError: CannotRead or TooLarge.
std::string readStrokeText(const std::filesystem::path& path, std::size_t maxBytes);

/// Checks that the lattice can represent the stroke's radii and detail_length, and that its positions are within the
/// working volume. Samples of a ray may start anywhere. Throws StrokeFileError::OutOfRange, with the index of the
/// sample if a sample is at fault. `offset` is the document's origin in the file's coordinates; the error's range is
/// given in those. With a non-zero `offset` the error's key names the first coordinate that is out of range, for
/// example position[0].
void requireFit(const Stroke& stroke, const Lattice& lattice, const Vec3& offset = Vec3::Zero());

/// Writes every key, and numbers with enough digits that reading returns bit-identical values.
void writeStrokes(std::ostream& out, const std::vector<FileEntry>& entries);
} // namespace core
