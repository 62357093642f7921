#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace core
{
/// Kinds of file error. The user interface makes the messages (ui/util/error_messages.h). The comment of a kind names
/// the fields of FileError that it sets beyond the path.
enum class FileErrorKind {
    // Errors of reading
    NotFound,
    NotReadable,          ///< systemError, if known
    NotAFile,             ///< a folder, device or pipe; also an error of writing
    FolderNotReadable,    ///< systemError, if known
    NoModel,              ///< a folder without any file whose name is that of a model
    Empty,                ///< a file of 0 bytes
    TooLarge,             ///< expected: the largest size in bytes that is read; found: the file's size in bytes
    UnknownFormat,        ///< token: the file name's extension, without dot
    NotWhatItsEndingSays, ///< token: format that the content looks like ("ply", "stl", "obj", "png", ...), or empty
    Utf16,                ///< text in UTF-16; only UTF-8 is read
    /// place: where data is missing, often the file's end. token: "vertices" or "faces"; expected: their number as
    /// announced; found: as the file has room for. Or no token; expected, found: sizes in bytes, if known
    CutOff,
    /// place, expected: elements announced; found: elements that the file has room for, or has if the token is "faces"
    CountMismatch,
    Malformed,       ///< place, fault; token: the text found there or the thing at fault, or empty
    NotANumber,      ///< place; token: the text that is not a finite number, empty in binary files
    IndexOutOfRange, ///< place; token: the index as written; expected: number of vertices
    OutsideFolder,   ///< token: another file that this file refers to, outside its folder
    UnpacksTooLarge, ///< expected: largest number of bytes that a file of this size may unpack to
    /// place; token: "vertices", "faces" or "corners"; expected: the largest number that is read
    TooManyElements,
    ReaderRefused,     ///< an external reader refused the file; token: its message, or empty
    ReaderDied,        ///< an external reader crashed
    ReaderTooSlow,     ///< an external reader was killed; expected: its time limit, seconds
    ReaderOutOfMemory, ///< an external reader ran out of memory; expected: its limit in bytes
    NoFaces,           ///< the file has no faces to sculpt; expected: number of slicer's parts that were left out
    // Errors of writing; nothing has changed on disk
    NotWritten,  ///< a format that can only be read; token: the extension, without dot
    TooFar,      ///< the model is so far from the origin that 32-bit floats cannot represent its detail
    NoFolder,    ///< the parent folder does not exist
    NotWritable, ///< not permitted; sets systemError
    DiskFull,    ///< sets systemError
    WriteFailed  ///< any other failure; sets systemError
};

/// Detail of a Malformed file. Up to PositiveNumber, a value names what was expected at the place; the token is the
/// text found instead, or empty. From Missing on, a value names what is wrong with the token.
enum class FileFault {
    None,
    Keyword,         ///< a keyword; `wanted` is the one expected
    Number,          ///< a decimal number
    WholeNumber,     ///< a decimal number without a fraction
    Count,           ///< a non-negative whole number
    VertexNumbers,   ///< 3 or 4 coordinates of a vertex, with 3 colour components or none
    VertexIndex,     ///< index of a vertex
    PlyEncoding,     ///< ascii, binary_little_endian or binary_big_endian
    NumberType,      ///< name of a number type
    WholeNumberType, ///< name of an integer type
    Name,            ///< name of an element or a property
    ElementFirst,    ///< an element; found a property before the first one
    Coordinates,     ///< the properties x, y and z
    Json,            ///< valid JSON
    JsonChunk,       ///< a first GLB chunk of type JSON
    Base64,          ///< base64 data within a URI
    LengthUnit,      ///< a unit of length known to 3MF or AMF
    PositiveNumber,  ///< a number above 0
    Missing,         ///< the token is required or referred to, but does not exist
    Repeated,        ///< the token occurs twice
    NotAList,        ///< JSON value of another type than list
    NotAnObject,     ///< JSON value of another type than object
    NotAnIndex,      ///< JSON value that is no whole number from 0 up
    NotNumbers,      ///< JSON or X3D value that is not numbers, or has the wrong count of them
    BeyondItsData,   ///< the token needs more bytes than its data has
    WrongAccessor,   ///< the type or count of a glTF accessor does not fit the token that uses it
    TooDeep,         ///< nested too deeply, or contains itself
    /// an extension that the shape depends on and that is not supported; expected: file size in bytes, only for Draco
    NeedsExtension,
    OldGltf,         ///< glTF of a version before 2
    CompressedCut,   ///< compressed data that ends too early
    CompressedWrong, ///< compressed data that is corrupt
    OldFbx,          ///< FBX of a version before 7.1
    OtherIfc,        ///< IFC of another schema than IFC2X3, the token
    NotRead,         ///< the token changes the shape, and is not read
    NotInScene,      ///< no object with faces is connected to the scene; token: the first of them
    OutsidePackage,  ///< a path that leads out of the package
    NotInPackage,    ///< the package has no part of this name
    NoModelPart,     ///< the package's relationships name no model part
    PackedOtherwise, ///< encrypted, or compressed by an unsupported method
    XmlSyntax,       ///< the token is Expat's message
    XmlDocumentType, ///< a document type declaration, which is refused for safety
    XmlTooDeep,
    XmlLongTag
};

/// A position in a file.
struct FilePlace
{
    enum class Unit { None, Line, Byte };
    Unit unit = Unit::None;
    std::uint64_t number = 0; ///< line number from 1, or byte offset from 0

    friend bool operator==(const FilePlace&, const FilePlace&) = default;
};

/// Thrown by readers and writers of files.
struct FileError : std::runtime_error
{
    /// `systemProblem`: the system code (system_code.h), or 0 if the system reported none.
    FileError(FileErrorKind errorKind, std::filesystem::path filePath, int systemProblem = 0)
        : std::runtime_error("file error")
        , kind(errorKind)
        , path(std::move(filePath))
        , systemError(systemProblem)
    {}

    FileErrorKind kind;
    std::filesystem::path path;
    FilePlace place;
    std::string token; ///< printable ASCII, at most 40 bytes; at most 200 bytes if kind is ReaderRefused
    FileFault fault = FileFault::None;
    std::string wanted; ///< keyword that was expected, if fault is Keyword
    std::uint64_t expected = 0;
    std::uint64_t found = 0;
    int systemError;
};
} // namespace core
