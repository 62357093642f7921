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
    CutOff,               ///< place: where something is missing, often the file's end; expected, found: sizes, if known
    CountMismatch,        ///< place, expected: elements announced; found: elements that the file has room for
    Malformed,            ///< place, token: what cannot be understood there, or empty
    NotANumber,           ///< place, token: the word that is not a number, or is infinite or NaN; empty in binary files
    IndexOutOfRange,      ///< place, token: the index as written, expected: number of vertices
    OutsideFolder,        ///< token: another file that it names, which is not in its folder
    UnpacksTooLarge,      ///< expected: the most bytes that are unpacked of a file of its size
    TooManyElements,      ///< place, token: what ("vertices", "faces", "corners"), expected: the most that is taken
    ReaderRefused,        ///< an external reader; token: what it says, or empty
    ReaderDied,           ///< an external reader broke off
    ReaderTooSlow,        ///< an external reader was ended; expected: seconds that it had
    ReaderOutOfMemory,    ///< an external reader; expected: bytes that it had
    NoFaces,              ///< vertices perhaps, but nothing to sculpt
    // Writing; nothing has changed on disk
    NotWritten,  ///< a format that is only read; token: the ending
    NoFolder,    ///< the folder that the file would be in is not there
    NotWritable, ///< not permitted; systemError
    DiskFull,    ///< systemError
    WriteFailed  ///< systemError
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
    std::string token; ///< at most 40 bytes, printable ASCII
    std::uint64_t expected = 0;
    std::uint64_t found = 0;
    int systemError;
};
} // namespace core
