#pragma once

#include "core/io/mesh_io.h"
#include "core/util/atomic_file.h"
#include "core/util/file_error.h"

#include <string_view>

/// What the readers and writers of the formats share; for mesh_io only.
namespace core::io
{
struct FileBytes
{
    const std::filesystem::path& path;
    std::string_view bytes;
    std::stop_token stop = {};
    bool isStandalone = false; ///< nothing lies beside it that it may name
};

/// To be asked for each element; looks every so many, which take about a millisecond.
class StopCheck
{
public:
    explicit StopCheck(std::stop_token stop) : m_stop(std::move(stop)) {}

    /// The element takes as long as so many do.
    void operator()(std::size_t elements = 1)
    {
        constexpr std::size_t checkInterval = 1 << 12;
        m_count += elements;
        if (m_count < checkInterval)
            return;
        m_count = 0;
        if (m_stop.stop_requested())
            throw ReadingCancelled();
    }

private:
    std::stop_token m_stop;
    std::size_t m_count = 0;
};

/// Beyond these a file is refused: 2 GiB can hold more, this machine's memory perhaps not.
inline constexpr std::size_t maxVertices = std::size_t(1) << 27;
inline constexpr std::size_t maxFaces = std::size_t(1) << 28;

/// So much of a file is looked at before the rest is read.
inline constexpr std::size_t startSize = 4096;

/// `at` points into the file; the place is its line, or its byte.
FileError errorAtLine(FileErrorKind kind, const FileBytes& file, const char* at, std::string_view token = {});
FileError errorAtByte(FileErrorKind kind, const FileBytes& file, const char* at, std::string_view token = {});
FileError errorWithToken(FileErrorKind kind, const FileBytes& file, std::string_view token);
FileError tooMany(std::string_view what, std::size_t max, FileError error);
FileError withCounts(FileError error, std::uint64_t expected, std::uint64_t found = 0);
/// Returns the error as Malformed, with the fault; `wanted`: see FileError.
FileError malformed(FileFault fault, FileError error, std::string_view wanted = {});

/// Returns the text behind a UTF-8 byte order mark, if it begins with one.
std::string_view withoutMark(std::string_view text);
/// Returns the text without the NUL and Ctrl+Z that old systems and padding put behind it, and the blanks between them.
std::string_view withoutPadding(std::string_view text);

/// Returns the format by the first bytes and the size: "stl", "obj", "ply", "off", another format's name ("png",
/// "zip", ...), "utf-16", "text", or an empty text.
std::string_view detectFormat(std::string_view start, std::uint64_t fileSize);

inline constexpr std::size_t stlHeaderSize = 84;
inline constexpr std::size_t stlTriangleSize = 50;
/// `start` holds the header.
std::uint64_t announcedStlTriangles(std::string_view start);
/// The size is what the header announces. Text never passes: four of its characters announce more than a file can hold.
bool isBinaryStl(std::string_view start, std::uint64_t fileSize);
bool isTextStl(std::string_view start);
/// Returns whether BINARY follows the keyword OFF.
bool isBinaryOff(std::string_view start);

/// Vertices as they stand in the file, axes included, but for the weld and -0 of STL.
ReadResult readStl(const FileBytes& file);
ReadResult readObj(const FileBytes& file);
ReadResult readPly(const FileBytes& file);
ReadResult readOff(const FileBytes& file);
ReadResult readGltf(const FileBytes& file, bool isBinary); ///< in mm
/// In mm. Memory: some ten times the file; at worst (packed a hundredfold, objects placed very often) a thousand times.
ReadResult readThreeMf(const FileBytes& file);
ReadResult readAmf(const FileBytes& file); ///< in mm, from XML or a zip of it; memory as with 3MF

void writeStl(AtomicFile& out, const TriangleMesh& mesh, bool ascii);
void writeObj(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette);
void writePly(AtomicFile& out, const TriangleMesh& mesh, const WriteOptions& options);
void writeOff(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette);
void writeGlb(AtomicFile& out, const TriangleMesh& mesh, const DocumentMetadata& metadata);
void writeThreeMf(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette);
} // namespace core::io
