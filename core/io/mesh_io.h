#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/io/document_metadata.h"

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

namespace core
{
/// Formats that are read; all but the last two are written, too.
enum class MeshFormat { Stl, Obj, Ply, Off, Glb, ThreeMf, Gltf, Amf };

/// The formats by their endings (lower case, without dot), in the order of MeshFormat.
std::span<const std::string_view> meshEndings();
/// Of those that are written.
std::span<const std::string_view> writtenEndings();
/// Of all that are read: ours, then those of the external reader (external_reader.h).
std::vector<std::string_view> readEndings();
/// By the ending, in either case.
std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& path);
/// Whether writeMesh() takes that ending.
bool isWritten(const std::filesystem::path& path);

/// Which axis of a file points up. In a document it is Y.
enum class UpAxis { Y, Z };
/// STL, 3MF and AMF: Z, the print bed's habit. The others: Y.
UpAxis usualUp(MeshFormat format);

bool holdsColors(MeshFormat format);

struct ReadOptions
{
    std::optional<UpAxis> up = {}; ///< of the file; missing: usualUp
    std::stop_token stop = {};     ///< then ReadingCancelled is thrown, within some 20 ms
};

/// What a file holds and a sculpted model does not.
struct ReadRemarks
{
    std::size_t objects = 1; ///< they are one mesh now
    bool materials = false, textures = false;
    bool poses = false;              ///< skins and morph targets: the model stands as its file shows it at rest
    std::size_t repeatedCorners = 0; ///< corners left out that a polygon names twice in a row
    std::size_t facesOfFewer = 0;    ///< faces left out with fewer than three different corners
    bool unannounced = false;        ///< values were left out that the file's header does not announce
    std::uint64_t bytesBehind = 0;   ///< the bytes behind a binary model, left out
    std::size_t negativeParts = 0;   ///< parts left out that a slicer would cut out of the model
    std::size_t otherParts = 0;      ///< parts left out that are no matter: modifiers and supports of slicers
    std::size_t otherModels = 0;     ///< models left out that are in the same package
    bool curves = false;             ///< edges and triangles that the file bends are straight and flat
    std::size_t beams = 0;           ///< beams of a lattice, left out
    std::size_t animations = 0;      ///< left out: the model stands as it does without them
    std::size_t subdivisions = 0;    ///< meshes that their program would subdivide, and that are read as they are
    std::size_t unreadNodes = 0;     ///< nodes, links and objects left out: surfaces that cannot be read

    friend bool operator==(const ReadRemarks&, const ReadRemarks&) = default;
};

struct ReadResult
{
    TriangleMesh mesh;
    ReadRemarks remarks;
};

/// What was read is not wanted any more.
struct ReadingCancelled
{};

struct WriteOptions
{
    std::optional<UpAxis> up = {}; ///< of the file; missing: usualUp
    bool ascii = false;            ///< STL and PLY as text. OBJ and OFF are text always, GLB and 3MF never.
    /// Kept beside the surface, where the format can: all of it by GLB, in an extension that others pass over; the
    /// palette by PLY, OBJ, OFF and 3MF, in a comment.
    DocumentMetadata metadata = {};
};

/// Throws FileError. What it returns has at least one face, indices in range and finite points, and three different
/// corners in each face, nothing more: faces may be without area, vertices unused. Vertices of equal bits (-0 = 0) are
/// one, whatever the format: STL knows no others, and other files split them along seams. Vertices and faces keep their
/// order; polygons are cut into triangles, and corners that they name twice in a row are left out. Text numbers are
/// rounded to the nearest float32. A file is not read beyond its header when it is too short for it. Units are the
/// file's; glTF's metres and the unit that a 3MF or AMF names become millimetres. What a .gltf names must lie in its
/// folder, links followed.
ReadResult readModel(const std::filesystem::path& path, const ReadOptions& options = {});
/// Its mesh alone.
TriangleMesh readMesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// readMesh() of a file that is in memory already; `name` says its format, and is told in errors. What names other
/// files is refused, and so is what only the external reader reads.
TriangleMesh parseMesh(const std::filesystem::path& name, std::string_view bytes);

/// What writeMesh() was given as notes, as far as the format keeps them. What is not as we write it is left out; so is
/// all of a file that cannot be read. Never throws FileError.
DocumentMetadata readMetadata(const std::filesystem::path& path);

/// Throws FileError; then the path holds what it held before. Read again, points and colours come back bit for bit
/// (STL: no colours, no unused vertices, no -0; 3MF: no colours of unused vertices).
void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh, const WriteOptions& options = {});
} // namespace core
