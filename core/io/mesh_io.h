#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/io/document_metadata.h"
#include "core/parts/part_list.h"

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

namespace core
{
/// Formats that can be read; all except the last two can also be written.
enum class MeshFormat { Stl, Obj, Ply, Off, Glb, ThreeMf, Gltf, Amf };

/// Returns the file name extension of each format (lower case, without dot), in the order of MeshFormat.
std::span<const std::string_view> meshEndings();
/// Returns the extensions of the formats that can be written.
std::span<const std::string_view> writtenEndings();
/// Returns the extensions of all formats that can be read: core's own, then those of the external reader
/// (external_reader.h).
std::vector<std::string_view> readEndings();
/// Returns the format for the path's extension, in upper or lower case.
std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& path);
/// Returns whether writeMesh() accepts the path's extension.
bool isWritten(const std::filesystem::path& path);

/// The axis of a file that points up. Documents always have Y up.
enum class UpAxis { Y, Z };
/// Returns the up axis that is usual for the format. Z for STL, 3MF and AMF, as on print beds; Y for the others.
UpAxis usualUp(MeshFormat format);

bool holdsColors(MeshFormat format);
/// Returns whether files of the format can have several objects, which ReadOptions::keepsObjects makes parts of, and
/// whether parts are written as objects to it.
bool holdsObjects(MeshFormat format);
/// Returns whether the format keeps the properties of parts, so that hidden parts can be written to it.
bool holdsHiddenParts(MeshFormat format);

struct ReadOptions
{
    std::optional<UpAxis> up = {}; ///< up axis of the file; missing: usualUp()
    std::stop_token stop = {};     ///< requests cancelling: readModel() then throws ReadingCancelled within about 20 ms
    /// Makes a part of each object of the file, if there are several, but not more than PartList::maxParts. Otherwise
    /// only a document of several parts (a GLB with FETTLE_document) keeps them.
    bool keepsObjects = false;
};

/// Content of a file that the resulting mesh does not keep, to be reported to the user.
struct ReadRemarks
{
    std::size_t objects = 1; ///< objects in the file that were merged into one mesh; 1 if they became parts
    bool materials = false, textures = false;
    /// The file has skins or morph targets; the mesh has the pose in which the file shows it.
    bool poses = false;
    std::size_t repeatedCorners = 0; ///< corners of polygons skipped: repeated, or part of a slit
    std::size_t facesOfFewer = 0;    ///< faces skipped because they have fewer than three different corners
    bool unannounced = false;        ///< values were skipped that the file's header does not declare
    std::uint64_t bytesBehind = 0;   ///< bytes after the end of a binary model, skipped
    /// Number of triangles that a binary STL announces, and number that it contains, if they differ.
    std::optional<std::uint64_t> announcedTriangles = {};
    std::uint64_t containedTriangles = 0;
    std::size_t negativeParts = 0; ///< parts skipped that a slicer would subtract from the model
    std::size_t otherParts = 0;    ///< parts skipped that are not solid: a slicer's modifiers and supports
    /// Names of the first of these parts, as leaveOutPart() keeps them.
    std::vector<std::string> negativeNames = {}, otherNames = {};
    std::size_t otherModels = 0;   ///< other models in the same package, skipped
    bool curves = false;           ///< the file has curved edges or triangles; they were read as straight and flat
    std::size_t beams = 0;         ///< beams of a 3MF beam lattice, skipped
    std::size_t animations = 0;    ///< animations, skipped: the mesh has its unanimated shape
    std::size_t subdivisions = 0;  ///< subdivision surfaces, read as their control meshes without subdividing
    std::size_t hiddenObjects = 0; ///< objects with meshes skipped because they are hidden, or in no scene or build
    std::size_t unreadNodes = 0;   ///< nodes, links and objects skipped because their surfaces cannot be read

    friend bool operator==(const ReadRemarks&, const ReadRemarks&) = default;
};

struct ReadResult
{
    TriangleMesh mesh;
    ReadRemarks remarks;
    /// Names of the parts, and other properties if the file is a document of Fettle. The mesh has labels if there are
    /// several parts. Formats without objects have one part.
    PartList parts = {};
};

/// Thrown by readers when a cancel was requested.
struct ReadingCancelled
{};

struct WriteOptions
{
    std::optional<UpAxis> up = {}; ///< up axis of the file; missing: usualUp()
    bool ascii = false;            ///< writes STL and PLY as text; OBJ and OFF are always text, GLB and 3MF never
    /// Data to be stored in addition to the surface. GLB stores all of it, in an extension that other programs ignore.
    /// PLY, OBJ, OFF and 3MF store only the palette, in a comment; other formats store nothing.
    DocumentMetadata metadata = {};
    /// Names, order and other properties of the mesh's parts; missing: those of the metadata's frame. The parts follow
    /// each other in the file in this order.
    std::optional<PartList> parts = {};
};

/// Reads a model of any supported format. Throws FileError. The result has at least one face, indices in range, finite
/// points, and three different corners in each face. Nothing more is guaranteed: faces may have no area, vertices may
/// be unused. Vertices with equal bits (-0 = 0) are merged in every format, because STL stores no shared vertices and
/// other files split vertices along seams; but vertices of different parts are not merged. Vertices and faces keep
/// their order. Polygons are triangulated, without repeated corners and slits. Numbers in text are rounded to the
/// nearest float32. If a binary STL ends within a triangle that its header declares, only its start is read. Units are
/// the file's; glTF's metres and the units named in 3MF and AMF files are converted to mm. Files that a .gltf
/// references must be in its folder after resolving symbolic links.
ReadResult readModel(const std::filesystem::path& path, const ReadOptions& options = {});
/// Returns only the mesh of readModel().
TriangleMesh readMesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Parses a file that is already in memory, as readMesh(). `name` determines the format and is reported in errors.
/// Refuses models that reference other files, and formats that only the external reader can read.
TriangleMesh parseMesh(const std::filesystem::path& name, std::string_view bytes);

/// Returns the metadata that writeMesh() stored in the file. Ignores entries that writeMesh() would not have written,
/// and everything if the file cannot be read. Never throws FileError.
DocumentMetadata readMetadata(const std::filesystem::path& path);

/// Writes the mesh. Throws FileError; the previous file is then unchanged. Points and colours are bit-identical when
/// read back, with these exceptions. STL keeps no colours and no unused vertices; 3MF keeps no colours of unused
/// vertices. STL, and any format if Z is up, keeps no -0. Reading merges equal points.
void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh, const WriteOptions& options = {});
} // namespace core
