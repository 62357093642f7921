// Reading is done in two steps: check the file's first bytes and its size and refuse what cannot be valid; then read
// the whole file and parse it.

#include "core/io/mesh_io.h"

#include "core/io/external_reader.h"
#include "core/io/large_buffer.h"
#include "core/io/mesh/format.h"
#include "core/io/mesh/glb_metadata.h"
#include "core/io/mesh/gltf_draco.h"
#include "core/io/mesh/input_file.h"
#include "core/io/mesh/palette.h"
#include "core/io/mesh/vertex_welder.h"
#include "core/parts/part_split.h"
#include "core/util/parallel.h"
#include "core/util/system_path.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cctype>
#include <fstream>
#include <memory>

namespace core
{
namespace
{
constexpr std::array<std::string_view, 8> endings{"stl", "obj", "ply", "off", "glb", "3mf", "gltf", "amf"};
constexpr std::size_t written = 6;
constexpr std::uint64_t maxFileSize = std::uint64_t(1) << 31;

/// Returns the extension in lower case: "glb" for "vase.glb", and also for "vase.glb~1", a backup of an earlier version
/// (numbered_backup.h).
std::string endingOf(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    if (!ending.empty())
        ending.erase(0, 1);
    const std::size_t version = ending.find('~');
    if (version != std::string::npos && version + 1 < ending.size() &&
        ending.find_first_not_of("0123456789", version + 1) == std::string::npos)
        ending.resize(version);
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

std::string printable(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string result(text.substr(0, longest));
    std::ranges::replace_if(
        result, [](char c) { return c < ' ' || c > '~'; }, '?');
    return result;
}

MeshFormat requireFormat(const std::filesystem::path& path)
{
    if (const auto format = meshFormatOf(path))
        return *format;
    throw io::errorWithToken(FileErrorKind::UnknownFormat, {path, {}}, endingOf(path));
}

std::uint64_t requireFileSize(const std::filesystem::path& path)
{
    using Type = std::filesystem::file_type;
    const FileStatus status = fileStatus(path);
    if (status.type == Type::not_found)
        throw FileError(FileErrorKind::NotFound, path);
    if (status.type == Type::none || status.type == Type::unknown)
        throw FileError(FileErrorKind::NotReadable, path, status.systemCode);
    if (status.type != Type::regular)
        throw FileError(FileErrorKind::NotAFile, path);
    return status.size;
}

void refuseSize(const std::filesystem::path& path, std::uint64_t size)
{
    if (size == 0)
        throw FileError(FileErrorKind::Empty, path);
    if (size > maxFileSize)
        throw io::withCounts({FileErrorKind::TooLarge, path}, maxFileSize, size);
}

void refuseOtherContent(const io::FileBytes& start, std::uint64_t size, MeshFormat format)
{
    const std::string_view detected = io::detectFormat(start.bytes, size);
    if (detected == endings[static_cast<std::size_t>(format)] || (format == MeshFormat::ThreeMf && detected == "zip"))
        return;
    if (detected == "utf-16" && format != MeshFormat::Glb && format != MeshFormat::ThreeMf)
        throw FileError(FileErrorKind::Utf16, start.path);
    const std::string_view text = io::withoutPadding(start.bytes);
    const bool isWithoutZeros = !text.empty() && text.find('\0') == std::string_view::npos;
    const bool couldBe = format == MeshFormat::Obj    ? detected == "text" || (detected.empty() && isWithoutZeros)
                         : format == MeshFormat::Gltf ? detected == "text"
                         : format == MeshFormat::Amf  ? detected == "xml" || detected == "zip" || detected == "text"
                         : format == MeshFormat::Stl  ? detected.empty()
                                                      : false;
    if (!couldBe)
        throw io::errorAtByte(FileErrorKind::NotWhatItsEndingSays, start, start.bytes.data(), detected);
}

void refuseStlSize(const io::FileBytes& start, std::uint64_t size)
{
    if (io::isBinaryStl(start.bytes, size) || io::isTextStl(start.bytes))
        return;
    if (size < io::stlHeaderSize)
        throw io::errorAtByte(FileErrorKind::CutOff, start, start.bytes.data() + size);
    const std::uint64_t announced = io::announcedStlTriangles(start.bytes);
    const std::uint64_t room = (size - io::stlHeaderSize) / io::stlTriangleSize;
    const std::uint64_t rest = (size - io::stlHeaderSize) % io::stlTriangleSize;
    // The reader decides about a file of whole triangles.
    if (announced == room || (room != 0 && rest == 0) || (announced != 0 && announced < room))
        return;
    if (announced > room)
        throw io::stlCutOff(start.path, announced == io::unknownStlTriangles ? room + 1 : announced, size);
    FileError error = io::withCounts({FileErrorKind::CountMismatch, start.path}, announced, room);
    error.place = {FilePlace::Unit::Byte, io::stlHeaderSize - 4};
    throw error;
}

/// Reads the whole file on all cores.
LargeBuffer<char> allOf(const io::InputFile& input, const std::filesystem::path& path, std::uint64_t size,
                        const std::stop_token& stop)
{
    constexpr std::size_t atOnce = 1 << 22;
    LargeBuffer<char> bytes(size);
    forEachChunk(size, atOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
        if (stop.stop_requested())
            throw ReadingCancelled();
        if (const std::size_t got = input.read(begin, bytes.part(begin, end)); got < end - begin)
            throw io::errorAtByte(FileErrorKind::CutOff, {path, {bytes.data(), size}},
                                  bytes.data() + begin + got); // the file was shortened while it was read
    });
    return bytes;
}

ReadResult parse(const io::FileBytes& file, MeshFormat format)
{
    switch (format) {
    case MeshFormat::Stl:
        return io::readStl(file);
    case MeshFormat::Obj:
        return io::readObj(file);
    case MeshFormat::Ply:
        return io::readPly(file);
    case MeshFormat::Off:
        return io::readOff(file);
    case MeshFormat::Glb:
    case MeshFormat::Gltf:
        return io::readGltf(file, format == MeshFormat::Glb);
    case MeshFormat::ThreeMf:
        return io::readThreeMf(file);
    case MeshFormat::Amf:
        return io::readAmf(file);
    }
    return {};
}

bool isExternal(const std::filesystem::path& path)
{
    return std::ranges::find(externalReader().endings, endingOf(path)) != externalReader().endings.end();
}

float negated(float x)
{
    return x == 0 ? 0 : -x;
}

/// Turns a file with Z up to the document's Y up: (x, y, z) becomes (x, z, -y). toZUp() is the inverse: (x, y, z)
/// becomes (x, -z, y).
void fromZUp(std::vector<Vec3f>& points)
{
    for (Vec3f& p : points)
        p = Vec3f(p.x() + 0.0f, p.z() + 0.0f, negated(p.y())); // adding 0 removes the sign of -0
}

void toZUp(std::vector<Vec3f>& points)
{
    for (Vec3f& p : points)
        p = Vec3f(p.x() + 0.0f, negated(p.z()), p.y() + 0.0f);
}

void refuseStart(const io::FileBytes& start, std::uint64_t size, MeshFormat format)
{
    refuseOtherContent(start, size, format);
    if (format == MeshFormat::Stl)
        refuseStlSize(start, size);
}

bool isWeldedByReader(MeshFormat format)
{
    return format == MeshFormat::Stl;
}

bool hasThreeCorners(const Triangle& t)
{
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// Erases faces with fewer than three different corners, because they enclose nothing. Returns how many were erased.
std::size_t eraseFacesOfFewerCorners(std::vector<Triangle>& triangles)
{
    constexpr std::size_t chunkSize = 1 << 15;
    std::atomic<bool> areAny = false;
    forEachChunk(triangles.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        const auto part = std::span(triangles).subspan(begin, end - begin);
        if (!areAny && !std::ranges::all_of(part, hasThreeCorners))
            areAny = true;
    });
    return areAny ? std::erase_if(triangles, [](const Triangle& t) { return !hasThreeCorners(t); }) : 0;
}

/// Converts a parsed model to a document's conventions: welded vertices, faces with three different corners, Y up.
/// Throws FileError::NoFaces if no face remains.
void settle(ReadResult& result, const io::FileBytes& file, bool isWelded, UpAxis up)
{
    if (!isWelded)
        io::weld(result.mesh, file.stop);
    result.remarks.facesOfFewer += eraseFacesOfFewerCorners(result.mesh.triangles);
    if (!result.mesh.parts.empty())
        result.remarks.objects = 1;
    if (result.mesh.triangles.empty())
        throw io::withCounts({FileErrorKind::NoFaces, file.path},
                             result.remarks.negativeParts + result.remarks.otherParts);
    if (up == UpAxis::Z)
        fromZUp(result.mesh.points);
}

/// Returns whether the external reader could read a file for which core's own reader threw this error.
bool isForExternalReader(const FileError& error)
{
    return error.kind == FileErrorKind::Malformed && error.fault == FileFault::NeedsExtension &&
           error.token == io::dracoExtension && externalReader().readDraco;
}

ReadResult readOwn(const std::filesystem::path& path, std::uint64_t size, MeshFormat format, const ReadOptions& options)
{
    const io::InputFile input(path);
    std::array<char, io::startSize> start;
    refuseStart({path, {start.data(), input.read(0, start)}}, size, format);
    std::uint64_t bytesWithBuffers = 0;
    try {
        const LargeBuffer<char> bytes = allOf(input, path, size, options.stop);
        return parse({path, {bytes.data(), bytes.size()}, options.stop, false, options.keepsObjects}, format);
    } catch (const FileError& error) {
        if (!isForExternalReader(error))
            throw;
        bytesWithBuffers = error.expected;
    }
    return externalReader().readDraco(path, bytesWithBuffers, options);
}

ReadResult readExternal(const std::filesystem::path& path, std::uint64_t size, const ReadOptions& options)
{
    refuseSize(path, size);
    ReadResult result = externalReader().read(path, options);
    settle(result, {path, {}, options.stop}, false, options.up.value_or(UpAxis::Y));
    return result;
}

std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return std::filesystem::absolute(file).lexically_normal().parent_path();
}

DocumentMetadata withAbsoluteImages(DocumentMetadata metadata, const std::filesystem::path& folder)
{
    for (SavedReference& reference : metadata.references)
        reference.path = (folder / reference.path).lexically_normal();
    return metadata;
}

/// Makes the paths of images in the folder or below relative to the folder.
DocumentMetadata withRelativeImages(DocumentMetadata metadata, const std::filesystem::path& folder)
{
    for (SavedReference& reference : metadata.references)
        if (const auto below = reference.path.lexically_relative(folder); !below.empty() && *below.begin() != "..")
            reference.path = below;
    return metadata;
}
} // namespace

std::span<const std::string_view> meshEndings()
{
    return endings;
}

std::span<const std::string_view> writtenEndings()
{
    return std::span(endings).first(written);
}

std::vector<std::string_view> readEndings()
{
    std::vector<std::string_view> all(endings.begin(), endings.end());
    all.insert(all.end(), externalReader().endings.begin(), externalReader().endings.end());
    return all;
}

std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& path)
{
    const auto found = std::ranges::find(endings, endingOf(path));
    if (found == endings.end())
        return std::nullopt;
    return static_cast<MeshFormat>(found - endings.begin());
}

bool isWritten(const std::filesystem::path& path)
{
    const auto format = meshFormatOf(path);
    return format && static_cast<std::size_t>(*format) < written;
}

bool holdsColors(MeshFormat format)
{
    return format != MeshFormat::Stl;
}

bool holdsObjects(MeshFormat format)
{
    return format != MeshFormat::Stl && format != MeshFormat::Ply && format != MeshFormat::Off;
}

bool holdsHiddenParts(MeshFormat format)
{
    return format == MeshFormat::Glb;
}

UpAxis usualUp(MeshFormat format)
{
    const bool isOfPrinters = format == MeshFormat::Stl || format == MeshFormat::ThreeMf || format == MeshFormat::Amf;
    return isOfPrinters ? UpAxis::Z : UpAxis::Y;
}

ReadResult readModel(const std::filesystem::path& path, const ReadOptions& options)
{
    const std::uint64_t size = requireFileSize(path);
    if (isExternal(path))
        return readExternal(path, size, options);
    const MeshFormat format = requireFormat(path);
    refuseSize(path, size);
    ReadResult result = readOwn(path, size, format, options);
    settle(result, {path, {}, options.stop}, isWeldedByReader(format), options.up.value_or(usualUp(format)));
    return result;
}

TriangleMesh readMesh(const std::filesystem::path& path, const ReadOptions& options)
{
    return readModel(path, options).mesh;
}

TriangleMesh parseMesh(const std::filesystem::path& name, std::string_view bytes)
{
    const MeshFormat format = requireFormat(name);
    refuseSize(name, bytes.size());
    const io::FileBytes file{name, bytes, {}, true};
    refuseStart({name, bytes.substr(0, io::startSize)}, bytes.size(), format);
    ReadResult result = parse(file, format);
    settle(result, file, isWeldedByReader(format), usualUp(format));
    return std::move(result.mesh);
}

DocumentMetadata readMetadata(const std::filesystem::path& path)
{
    const auto format = meshFormatOf(path);
    if (!format || !holdsColors(*format))
        return {};
    std::ifstream stream(systemPath(path), std::ios::binary);
    if (format == MeshFormat::Glb)
        return withAbsoluteImages(io::readGlbMetadata(stream), folderOf(path));
    std::array<char, io::startSize> start;
    stream.read(start.data(), start.size());
    DocumentMetadata metadata;
    metadata.palette = io::paletteIn({start.data(), static_cast<std::size_t>(stream.gcount())});
    return metadata;
}

void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh, const WriteOptions& options)
{
    if ((isExternal(path) || meshFormatOf(path)) && !isWritten(path))
        throw io::errorWithToken(FileErrorKind::NotWritten, {path, {}}, endingOf(path));
    const MeshFormat format = requireFormat(path);
    const PartList known = options.parts            ? *options.parts
                           : options.metadata.frame ? options.metadata.frame->parts
                                                    : PartList();
    const PartList parts = listedParts(mesh, known);
    if (parts.size() > 1 && !std::ranges::is_sorted(mesh.parts, {}, [&](PartId part) { return parts.find(part); })) {
        WriteOptions sorted = options;
        sorted.parts = parts;
        return writeMesh(path, inListOrder(mesh, parts), sorted);
    }
    if (options.up.value_or(usualUp(format)) == UpAxis::Z) {
        TriangleMesh turned = mesh;
        toZUp(turned.points);
        WriteOptions asItIs = options;
        asItIs.up = UpAxis::Y;
        return writeMesh(path, turned, asItIs);
    }
    AtomicFile out(path);
    switch (format) {
    case MeshFormat::Stl:
        io::writeStl(out, mesh, options.ascii);
        break;
    case MeshFormat::Obj:
        io::writeObj(out, mesh, options.metadata.palette, parts);
        break;
    case MeshFormat::Ply:
        io::writePly(out, mesh, options);
        break;
    case MeshFormat::Off:
        io::writeOff(out, mesh, options.metadata.palette);
        break;
    case MeshFormat::Glb:
        io::writeGlb(out, mesh, withRelativeImages(options.metadata, folderOf(path)), parts);
        break;
    case MeshFormat::ThreeMf:
        io::writeThreeMf(out, mesh, options.metadata.palette, parts);
        break;
    case MeshFormat::Gltf:
    case MeshFormat::Amf:
        break; // refused by isWritten() above
    }
    out.commit();
}

namespace io
{
FileError errorWithToken(FileErrorKind kind, const FileBytes& file, std::string_view token)
{
    FileError error(kind, file.path);
    error.token = printable(token);
    return error;
}

namespace
{
std::uint64_t lineOf(std::string_view textBefore)
{
    const auto feeds = std::count(textBefore.begin(), textBefore.end(), '\n');
    const auto returns = feeds != 0 ? 0 : std::count(textBefore.begin(), textBefore.end(), '\r');
    return static_cast<std::uint64_t>(feeds + returns + 1);
}
} // namespace

FileError errorAtLine(FileErrorKind kind, const FileBytes& file, const char* at, std::string_view token)
{
    FileError error = errorWithToken(kind, file, token);
    const auto before = static_cast<std::size_t>(at - file.bytes.data());
    error.place = {FilePlace::Unit::Line, lineOf(file.bytes.substr(0, before))};
    return error;
}

FileError errorAtByte(FileErrorKind kind, const FileBytes& file, const char* at, std::string_view token)
{
    FileError error = errorWithToken(kind, file, token);
    error.place = {FilePlace::Unit::Byte, static_cast<std::uint64_t>(at - file.bytes.data())};
    return error;
}

FileError stlCutOff(const std::filesystem::path& path, std::uint64_t triangles, std::uint64_t size)
{
    FileError error = withCounts({FileErrorKind::CutOff, path}, stlHeaderSize + stlTriangleSize * triangles, size);
    error.place = {FilePlace::Unit::Byte, size};
    return error;
}

FileError tooMany(std::string_view what, std::size_t max, FileError error)
{
    error.kind = FileErrorKind::TooManyElements;
    error.token = what;
    return withCounts(std::move(error), max);
}

FileError malformed(FileFault fault, FileError error, std::string_view wanted)
{
    error.kind = FileErrorKind::Malformed;
    error.fault = fault;
    error.wanted = wanted;
    return error;
}

FileError withElements(FileError error, std::string_view what, std::uint64_t announced, std::uint64_t found)
{
    error.token = what;
    return withCounts(std::move(error), announced, found);
}

FileError withCounts(FileError error, std::uint64_t expected, std::uint64_t found)
{
    error.expected = expected;
    error.found = found;
    return error;
}
} // namespace io
} // namespace core
