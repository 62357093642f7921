#include "app/import/sandboxed_importer.h"

#include "app/import/assimp_import.h"
#include "app/import/import_parts.h"
#include "app/import/import_protocol.h"
#include "app/platform/child_process.h"

#include "core/util/file_error.h"
#include "core/util/system_path.h"

#include <algorithm>
#include <array>

namespace app
{
namespace
{
using core::FileError;
using core::FileErrorKind;
using core::TriangleMesh;

/// Extensions of formats with surfaces that Assimp 5.2 reads. Ambiguous extensions (raw, scn, xml, mesh) are left out.
/// Also left out are Blender's files, which differ without their modifiers, OpenGEX, in which Assimp ignores what is
/// below another node, and binary X3D, which Assimp reads as nothing.
constexpr std::array<std::string_view, 36> endings{
    "fbx", "dae", "3ds",  "x3d", "lwo", "lws",     "lxo", "dxf", "ifc",     "ac",  "ac3d", "acc",
    "ase", "b3d", "cob",  "hmp", "iqm", "irrmesh", "md2", "md3", "md5mesh", "mdc", "mdl",  "ms3d",
    "ndo", "nff", "enff", "pmx", "q3o", "q3s",     "sib", "smd", "x",       "xgl", "zae",  "zgl"};

FileError errorOf(FileErrorKind kind, const std::filesystem::path& path, std::uint64_t expected = 0)
{
    FileError error(kind, path);
    error.expected = expected;
    return error;
}

/// Reads the bytes of the result in order. Each read fails if too few bytes are left.
class ResultReader
{
public:
    explicit ResultReader(std::string_view bytes) : m_rest(bytes) {}

    bool read(void* to, std::size_t size)
    {
        if (size > m_rest.size())
            return false;
        std::copy_n(m_rest.data(), size,
                    static_cast<char*>(to)); // std::memcpy() must not get a null pointer, even for 0 bytes
        m_rest.remove_prefix(size);
        return true;
    }
    template <class Element> bool read(std::vector<Element>& to, std::uint64_t count)
    {
        if (count > m_rest.size() / sizeof(Element))
            return false;
        to.resize(count);
        return read(static_cast<void*>(to.data()), count * sizeof(Element));
    }
    bool atEnd() const { return m_rest.empty(); }

private:
    std::string_view m_rest;
};

bool isSound(const TriangleMesh& mesh)
{
    for (const core::Triangle& t : mesh.triangles)
        for (const core::Slot corner : t)
            if (corner >= mesh.points.size())
                return false;
    const auto isOnePerPoint = [&mesh](const auto& values) {
        return values.empty() || values.size() == mesh.points.size();
    };
    return isOnePerPoint(mesh.colors) && isOnePerPoint(mesh.masks) && isOnePerPoint(mesh.parts);
}

/// Returns the list of the mesh's parts; nothing if it is damaged or lacks a part of the mesh.
std::optional<core::PartList> partsOf(const TriangleMesh& mesh, std::string_view packed)
{
    if (mesh.parts.empty())
        return packed.empty() ? std::optional(core::PartList()) : std::nullopt;
    const auto list = unpackedParts(packed);
    std::vector<bool> isListed(std::size_t(core::maxPartId) + 1, false);
    if (list)
        for (const core::Part& part : list->all())
            isListed[part.id] = true;
    const auto hasPart = [&](core::PartId label) { return label <= core::maxPartId && isListed[label]; };
    return std::ranges::all_of(mesh.parts, hasPart) ? list : std::nullopt;
}

/// Returns the header's message, with "?" for each byte that is not printable ASCII.
std::string messageOf(const ImportHeader& header)
{
    std::string message = header.message;
    std::ranges::replace_if(
        message, [](char c) { return c < ' ' || c > '~'; }, '?');
    return message;
}

/// Returns the file that the process found faulty: the requested file, or one in its folder that it refers to.
std::filesystem::path faultyFile(const ImportHeader& header, const std::filesystem::path& path)
{
    const std::string_view name = header.file;
    const bool isPrintable = std::ranges::none_of(name, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; });
    try {
        const std::filesystem::path file = core::pathOfUtf8(name);
        const bool isWithin = !file.empty() && file.is_relative() && *file.lexically_normal().begin() != "..";
        return isPrintable && isWithin ? path.parent_path() / file : path;
    } catch (const std::filesystem::filesystem_error&) {
        return path; // no UTF-8, which only Windows minds
    }
}

/// Returns the error that the process reported, or ReaderDied if its numbers are out of range.
FileError faultOf(const ImportHeader& header, const std::filesystem::path& path)
{
    if (header.kind > static_cast<std::uint32_t>(FileErrorKind::NoFaces) ||
        header.fault > static_cast<std::uint32_t>(core::FileFault::XmlLongTag) ||
        header.unit > static_cast<std::uint32_t>(core::FilePlace::Unit::Byte))
        return errorOf(FileErrorKind::ReaderDied, path);
    FileError error = errorOf(static_cast<FileErrorKind>(header.kind), faultyFile(header, path), header.expected);
    error.fault = static_cast<core::FileFault>(header.fault);
    error.place = {static_cast<core::FilePlace::Unit>(header.unit), header.place};
    error.found = header.found;
    error.token = messageOf(header);
    return error;
}

[[noreturn]] void refuse(const ImportHeader& header, const std::filesystem::path& path, const ImportLimits& limits)
{
    if (header.outcome == ImportHeader::Outcome::OutOfMemory)
        throw errorOf(FileErrorKind::ReaderOutOfMemory, path, limits.memory);
    if (header.outcome == ImportHeader::Outcome::Faulty)
        throw faultOf(header, path);
    const bool isOutside = header.outcome == ImportHeader::Outcome::Outside;
    FileError error = errorOf(isOutside ? FileErrorKind::OutsideFolder : FileErrorKind::ReaderRefused, path);
    error.token = messageOf(header);
    throw error;
}

core::ReadResult resultOf(std::string_view bytes, const std::filesystem::path& path, const ImportLimits& limits)
{
    ResultReader reader(bytes);
    ImportHeader header;
    if (!reader.read(&header, sizeof header) || header.magic != ImportHeader::magicNumber)
        throw errorOf(FileErrorKind::ReaderDied, path);
    header.message[sizeof header.message - 1] = 0;
    header.file[sizeof header.file - 1] = 0;
    if (header.outcome != ImportHeader::Outcome::Read)
        refuse(header, path, limits);
    core::ReadResult result;
    std::uint32_t end = 0;
    std::vector<char> packed;
    const bool isWhole =
        reader.read(result.mesh.points, header.points) && reader.read(result.mesh.colors, header.colors) &&
        reader.read(result.mesh.masks, header.masks) && reader.read(result.mesh.parts, header.labels) &&
        reader.read(result.mesh.triangles, header.triangles) && reader.read(packed, header.partBytes) &&
        reader.read(&end, sizeof end) && end == importEnd && reader.atEnd();
    if (!isWhole || !isSound(result.mesh))
        throw errorOf(FileErrorKind::ReaderDied, path);
    auto parts = partsOf(result.mesh, {packed.data(), packed.size()});
    if (!parts)
        throw errorOf(FileErrorKind::ReaderDied, path);
    result.parts = *std::move(parts);
    for (const core::Vec3f& point : result.mesh.points)
        if (!point.allFinite())
            throw errorOf(FileErrorKind::NotANumber, path);
    result.remarks = {.objects = header.objects,
                      .materials = header.materials != 0,
                      .textures = header.textures != 0,
                      .poses = header.poses != 0,
                      .repeatedCorners = header.repeatedCorners,
                      .facesOfFewer = header.facesOfFewer,
                      .animations = header.animations,
                      .subdivisions = header.subdivisions,
                      .hiddenObjects = header.hiddenObjects,
                      .unreadNodes = header.unreadNodes};
    return result;
}

/// Reads a file in an import process. `bytes`: size of the file and of the files it refers to.
core::ReadResult read(const std::string& program, const std::filesystem::path& path, std::uint64_t bytes,
                      const core::ReadOptions& options)
{
    const ImportLimits limits(bytes);
    ChildRequest request{{program, importWord, std::filesystem::absolute(path).string(), std::to_string(bytes),
                          options.keepsObjects ? importAsParts : "one"}};
    request.time = std::chrono::seconds(2 * limits.seconds);
    request.maxBytes =
        sizeof(ImportHeader) + sizeof importEnd + maxPackedParts +
        limits.points * (sizeof(core::Vec3f) + sizeof(core::Rgb) + sizeof(std::uint8_t) + sizeof(core::PartId)) +
        limits.triangles * sizeof(core::Triangle);
    request.stop = options.stop;
    const ChildResult result = runChild(request);
    switch (result.end) {
    case ChildResult::End::Stopped:
        throw core::ReadingCancelled();
    case ChildResult::End::TooSlow:
        throw errorOf(FileErrorKind::ReaderTooSlow, path, limits.seconds);
    case ChildResult::End::Died:
    case ChildResult::End::NotStarted:
        throw errorOf(FileErrorKind::ReaderDied, path);
    case ChildResult::End::Exited:
        break;
    }
    return resultOf(result.bytes, path, limits);
}
} // namespace

core::ExternalReader sandboxedImporter(const std::string& program)
{
    return {{endings.begin(), endings.end()},
            [program](const std::filesystem::path& path, const core::ReadOptions& options) {
                return read(program, path, std::filesystem::file_size(path), options);
            },
            [program](const std::filesystem::path& path, std::uint64_t bytes, const core::ReadOptions& options) {
                return read(program, path, bytes, options);
            }};
}

void installSandboxedImporter()
{
    core::setExternalReader(sandboxedImporter(ownProgram()));
}
} // namespace app
