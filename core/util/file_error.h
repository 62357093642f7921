#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace core
{
/// What is wrong with a file. The words for people are made elsewhere; each kind says what data comes with it beyond
/// the path.
enum class FileErrorKind {
    // Reading
    NotFound,
    NotReadable,          ///< systemError, if known
    NotAFile,             ///< a folder, device or pipe; also when writing
    FolderNotReadable,    ///< systemError, if known
    NoModel,              ///< a folder in which no file is named like a model
    Empty,                ///< no byte in it
    TooLarge,             ///< expected: the largest size in bytes that is read; found: its size
    UnknownFormat,        ///< token: the ending, without dot
    NotWhatItsEndingSays, ///< token: what the content looks like ("ply", "stl", "obj", "png", ...), or empty
    Utf16,                ///< text in UTF-16, where only UTF-8 is read
    CutOff,               ///< place: where something is missing, often the file's end; expected, found: sizes, if known
    CountMismatch,        ///< place, expected: elements announced; found: elements that the file has room for
    Malformed,            ///< place, fault; token: what is found there or what is wrong, or empty
    NotANumber,           ///< place, token: the word that is not a number, or is infinite or NaN; empty in binary files
    IndexOutOfRange,      ///< place, token: the index as written, expected: number of vertices
    OutsideFolder,        ///< token: another file that it names, which is not in its folder
    UnpacksTooLarge,      ///< expected: the most bytes that are unpacked of a file of its size
    TooManyElements,      ///< place, token: what ("vertices", "faces", "corners"), expected: the most that is taken
    ReaderRefused,        ///< an external reader; token: what it says, or empty
    ReaderDied,           ///< an external reader broke off
    ReaderTooSlow,        ///< an external reader was ended; expected: seconds that it had
    ReaderOutOfMemory,    ///< an external reader; expected: bytes that it had
    NoFaces,              ///< nothing to sculpt; expected: a slicer's parts that were left out
    // Writing; nothing has changed on disk
    NotWritten,  ///< a format that is only read; token: the ending
    TooFar,      ///< where the model's file has it, 32 bits are too few for the model's detail
    NoFolder,    ///< the folder that the file would be in is not there
    NotWritable, ///< not permitted; systemError
    DiskFull,    ///< systemError
    WriteFailed  ///< systemError
};

/// The fault of a file that is Malformed. Up to LengthUnit each value says what was expected at the place, and the
/// token is what was found instead, empty if nothing was; from Missing on the token is the thing that is at fault.
enum class FileFault {
    None,
    Keyword,         ///< wanted: the word
    Number,          ///< a decimal number
    WholeNumber,     ///< a decimal number without a fraction
    Count,           ///< a whole number, not negative
    VertexNumbers,   ///< 3 or 4 numbers of a vertex, and 3 of a colour or none
    VertexIndex,     ///< the number of a vertex
    PlyEncoding,     ///< ascii, binary_little_endian or binary_big_endian
    NumberType,      ///< the name of a type
    WholeNumberType, ///< the name of a type of whole numbers
    Name,            ///< of an element or a property
    ElementFirst,    ///< a property follows no element
    Coordinates,     ///< the properties x, y and z
    Json,            ///< it does not parse
    JsonChunk,       ///< a GLB's first chunk is not JSON
    Base64,          ///< data within a URI
    LengthUnit,      ///< one of those that 3MF and AMF have
    Missing,         ///< it is not there, though something needs it
    Repeated,        ///< it comes a second time
    NotAList,        ///< JSON of another type
    NotAnObject,     ///< JSON of another type
    NotAnIndex,      ///< JSON that is no whole number from 0 on
    NotNumbers,      ///< not so many numbers, or no numbers at all
    BeyondItsData,   ///< it has fewer bytes than are to be read of it
    WrongAccessor,   ///< its type or count is none that can be used for what names it
    TooDeep,         ///< it is nested too deeply, or holds itself
    NeedsExtension,  ///< without which the shape is not known; expected: bytes of a file that needs Draco
    OldGltf,         ///< glTF of a version before 2
    CompressedCut,   ///< compressed data that ends too early
    CompressedWrong, ///< compressed data that is not packed as it should be
    OldFbx,          ///< FBX of a version before 7.1
    OutsidePackage,  ///< a path that leads out of it
    NotInPackage,    ///< a part of that name
    NoModelPart,     ///< the package's list of relationships names none
    PackedOtherwise, ///< encrypted, or packed by a method that is not read
    XmlSyntax,
    XmlDocumentType, ///< which no XML may have that is read
    XmlTooDeep,
    XmlLongTag
};

/// Where in a file.
struct FilePlace
{
    enum class Unit { None, Line, Byte };
    Unit unit = Unit::None;
    std::uint64_t number = 0; ///< lines from 1, bytes from 0

    friend bool operator==(const FilePlace&, const FilePlace&) = default;
};

/// What readers and writers of files throw.
struct FileError : std::runtime_error
{
    /// `systemProblem`: errno, or 0.
    FileError(FileErrorKind errorKind, std::filesystem::path filePath, int systemProblem = 0)
        : std::runtime_error("file error")
        , kind(errorKind)
        , path(std::move(filePath))
        , systemError(systemProblem)
    {}

    FileErrorKind kind;
    std::filesystem::path path;
    FilePlace place;
    std::string token; ///< at most 40 bytes, or 200 of ReaderRefused, printable ASCII
    FileFault fault = FileFault::None;
    std::string wanted; ///< a word of the format, where the fault asks for one
    std::uint64_t expected = 0;
    std::uint64_t found = 0;
    int systemError;
};
} // namespace core
