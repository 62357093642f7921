#pragma once

#include "core/io/mesh_io.h"
#include "core/util/atomic_file.h"
#include "core/util/file_error.h"

#include <string_view>

/// Declarations shared by the readers and writers of all formats. Only mesh_io.cpp and they use this header.
namespace core::io
{
struct FileBytes
{
    const std::filesystem::path& path;
    std::string_view bytes;
    std::stop_token stop = {};
    bool isStandalone = false; ///< the file has no directory: references to other files are refused
    bool keepsObjects = false; ///< see ReadOptions
};

/// Checks for a cancel while elements are read. Call it for each element; it checks the token about once a millisecond.
/// Throws ReadingCancelled.
class StopCheck
{
public:
    explicit StopCheck(std::stop_token stop) : m_stop(std::move(stop)) {}

    /// Counts one element that takes as long as `elements` ordinary ones.
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

/// Largest numbers of vertices and faces that are read. A file of 2 GiB can contain more than memory can.
inline constexpr std::size_t maxVertices = std::size_t(1) << 27;
inline constexpr std::size_t maxFaces = std::size_t(1) << 28;

/// Number of bytes that are checked before the rest of a file is read.
inline constexpr std::size_t startSize = 4096;

/// Returns an error located at the line of `at`, which points into the file's bytes; errorAtByte() uses the byte
/// offset.
FileError errorAtLine(FileErrorKind kind, const FileBytes& file, const char* at, std::string_view token = {});
FileError errorAtByte(FileErrorKind kind, const FileBytes& file, const char* at, std::string_view token = {});
FileError errorWithToken(FileErrorKind kind, const FileBytes& file, std::string_view token);
FileError tooMany(std::string_view what, std::size_t max, FileError error);
FileError withCounts(FileError error, std::uint64_t expected, std::uint64_t found = 0);
/// Returns the error with the number of elements that the file announces, and that it has. `what`: "vertices" or
/// "faces".
FileError withElements(FileError error, std::string_view what, std::uint64_t announced, std::uint64_t found);
/// Returns the error as Malformed, with the fault; `wanted`: see FileError.
FileError malformed(FileFault fault, FileError error, std::string_view wanted = {});

/// Returns the text after its UTF-8 byte order mark, if there is one.
std::string_view withoutMark(std::string_view text);
/// Returns the text without trailing NUL and Ctrl+Z characters, which old systems and padding append, and without
/// blanks between them.
std::string_view withoutPadding(std::string_view text);
/// Returns the length in bytes of the UTF-8 character at the start of the text, 0 if there is none (RFC 3629).
/// Precondition: the text is not empty.
std::size_t utf8Length(std::string_view text);

/// Detects the format from the first bytes and the size. Returns "stl", "obj", "ply", "off", another format's name
/// ("png", "zip", ...), "utf-16", "text", or an empty text.
std::string_view detectFormat(std::string_view start, std::uint64_t fileSize);

inline constexpr std::size_t stlHeaderSize = 84;
inline constexpr std::size_t stlTriangleSize = 50;
/// Some programs write this number of triangles, or 0, when they do not know it yet.
inline constexpr std::uint64_t unknownStlTriangles = 0xffffffff;
/// Returns the number of triangles in the header of a binary STL. Precondition: `start` contains the whole header.
std::uint64_t announcedStlTriangles(std::string_view start);
/// Returns the error that a binary STL of `size` bytes has too few for so many triangles.
FileError stlCutOff(const std::filesystem::path& path, std::uint64_t triangles, std::uint64_t size);
/// Returns whether the file has exactly the size that its header declares. A text file never has: four text characters
/// there would declare more triangles than any file can contain.
bool isBinaryStl(std::string_view start, std::uint64_t fileSize);
bool isTextStl(std::string_view start);
/// Returns whether the keyword BINARY follows the keyword OFF.
bool isBinaryOff(std::string_view start);

/// Reads a file of one format. Vertices and axes are those of the file, except that STL is welded and its -0 become 0.
ReadResult readStl(const FileBytes& file);
ReadResult readObj(const FileBytes& file);
ReadResult readPly(const FileBytes& file);
ReadResult readOff(const FileBytes& file);
ReadResult readGltf(const FileBytes& file, bool isBinary); ///< points in mm
/// Reads a 3MF; points in mm. Memory: about ten times the file; in the worst case a thousand times, if it is packed a
/// hundredfold or places objects very often.
ReadResult readThreeMf(const FileBytes& file);
ReadResult readAmf(const FileBytes& file); ///< reads XML or a zip of it; points in mm; memory as for readThreeMf()

void writeStl(AtomicFile& out, const TriangleMesh& mesh, bool ascii);
/// Writes an object for each part; the same for 3MF. `parts`: listedParts() of the mesh.
void writeObj(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette, const PartList& parts);
void writePly(AtomicFile& out, const TriangleMesh& mesh, const WriteOptions& options);
void writeOff(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette);
/// Writes a node and a mesh for each part.
void writeGlb(AtomicFile& out, const TriangleMesh& mesh, const DocumentMetadata& metadata, const PartList& parts);
void writeThreeMf(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette, const PartList& parts);
} // namespace core::io
