#include "app/import/assimp_import.h"

#include "app/import/collada_check.h"
#include "app/import/draco_decoder.h"
#include "app/import/fbx_file.h"
#include "app/import/fbx_scene.h"
#include "app/import/foreign_unit.h"
#include "app/import/import_folder.h"
#include "app/import/import_parts.h"
#include "app/import/import_protocol.h"
#include "app/import/scene_mesh.h"
#include "app/platform/resource_limits.h"

#include "core/geometry/triangle_mesh.h"
#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/x3d_expansion.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "core/util/worker_pool.h"

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <new>

namespace app
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t startSize = 1 << 16; ///< bytes that are searched for versions and units

bool send(const void* data, std::size_t size)
{
    return size == 0 || std::fwrite(data, 1, size, stdout) == size; // data may be null if size is 0
}

template <class Element> bool send(const std::vector<Element>& elements)
{
    return send(elements.data(), elements.size() * sizeof(Element));
}

/// Sends the header with the sizes of the mesh and of its list of parts, then both.
int sendResult(ImportHeader header, const core::TriangleMesh& mesh, const core::PartList& parts = {})
{
    const std::string packed = mesh.parts.empty() ? std::string() : packedParts(parts);
    header.points = mesh.points.size();
    header.colors = mesh.colors.size();
    header.masks = mesh.masks.size();
    header.labels = mesh.parts.size();
    header.triangles = mesh.triangles.size();
    header.partBytes = packed.size();
    const bool isSent = send(&header, sizeof header) && send(mesh.points) && send(mesh.colors) && send(mesh.masks) &&
                        send(mesh.parts) && send(mesh.triangles) && send(packed.data(), packed.size()) &&
                        send(&importEnd, sizeof importEnd) && std::fflush(stdout) == 0;
    return isSent ? 0 : 1;
}

/// Copies the message into the header if all of it fits.
void setMessage(ImportHeader& header, std::string_view message)
{
    if (message.size() < sizeof header.message)
        std::ranges::copy(message, header.message);
}

int refuse(ImportHeader::Outcome outcome, std::string_view message)
{
    ImportHeader header;
    header.outcome = message.find("bad_alloc") != std::string_view::npos ? ImportHeader::Outcome::OutOfMemory : outcome;
    setMessage(header, message);
    return sendResult(header, {});
}

/// Puts the path of the faulty file into the header, unless it is the file to be read.
void setFile(ImportHeader& header, const fs::path& file, const fs::path& read)
{
    std::error_code problem;
    const fs::path whole = fs::weakly_canonical(file, problem), asked = fs::weakly_canonical(read, problem);
    const std::string name = whole == asked ? std::string() : whole.lexically_relative(asked.parent_path()).string();
    if (name.size() < sizeof header.file)
        std::ranges::copy(name, header.file);
}

int refuse(const core::FileError& error, const fs::path& read)
{
    ImportHeader header;
    setFile(header, error.path, read);
    header.outcome = ImportHeader::Outcome::Faulty;
    header.kind = static_cast<std::uint32_t>(error.kind);
    header.fault = static_cast<std::uint32_t>(error.fault);
    header.unit = static_cast<std::uint32_t>(error.place.unit);
    header.place = error.place.number;
    header.expected = error.expected;
    header.found = error.found;
    setMessage(header, error.token);
    return sendResult(header, {});
}

/// Returns Assimp's error message, with the file's path shortened to its name; empty if it says nothing of the file.
std::string wordsOf(const Assimp::Importer& importer, const fs::path& path)
{
    std::string words = importer.GetErrorString();
    for (const std::string_view empty : {"vector::", "basic_string::", "map::", "An unknown error"})
        if (words.starts_with(empty))
            return {};
    for (std::size_t at = words.find(path.string()); at != std::string::npos; at = words.find(path.string()))
        words.replace(at, path.string().size(), path.filename().string());
    return words.ends_with('.') ? words.substr(0, words.size() - 1) : words;
}

/// Records Assimp's error about the first mesh that it drops because the mesh is broken, and its warning about the
/// first corner that it moves.
class ErrorLog : public Assimp::LogStream
{
public:
    /// Attaches a new log to Assimp's logger and returns it. The logger owns the log; it stays attached until the
    /// process ends.
    static ErrorLog& attached()
    {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0); // 0: log to no file and no console
        auto* const log = new ErrorLog;                               // owned by the logger from now on
        Assimp::DefaultLogger::get()->attachStream(log, Assimp::Logger::Err | Assimp::Logger::Warn);
        return *log;
    }

    /// `message`: a line such as "Error, T0: FBX-DOM (TOK_KEY, line 27, col 23) description".
    void write(const char* message) override
    {
        constexpr std::string_view behindThread = ": ";
        const std::string_view words(message);
        const std::size_t at = words.find(behindThread);
        const bool isChange = isOfCorner(words);
        if (at == std::string_view::npos || !(isChange || (words.starts_with("Error") && isOfMesh(words))))
            return;
        std::string& first = isChange ? m_change : m_first;
        if (first.empty())
            first.assign(words, at + behindThread.size(),
                         words.find_last_not_of(" \r\n") + 1 - at - behindThread.size());
    }

    /// Returns the text of the first error about a mesh; empty if there was none.
    const std::string& first() const { return m_first; }
    /// Returns the text of the first warning that Assimp moved a corner; empty if there was none.
    const std::string& change() const { return m_change; }

private:
    /// Returns whether the warning is about a corner that does not exist, in whose place Assimp puts another.
    static bool isOfCorner(std::string_view words)
    {
        for (const std::string_view part :
             {"LWOB: face index is out of range", "face record, index is out of range", "3DS: Vertex index overflow",
              "NFF2: Vertex index overflow", "IRRMESH: Index out of range", "MD2: Vertex index is outside",
              "MDC vertex index is out of range", "Q1-MDL vertex list", "MDLn vertex list", "MDL7 vertex list",
              "Face has an invalid index"})
            if (words.find(part) != std::string_view::npos)
                return true;
        return false;
    }

    /// Returns whether the error can concern a mesh. Errors that occur only in materials, animations, blend shapes or
    /// meshes without faces do not count.
    static bool isOfMesh(std::string_view words)
    {
        for (const std::string_view part :
             {"index out of range", "is not a multiple of three", "binary data array", "MappingInformationType",
              "Cannot parse string", "cannot be converted into a value", "failed to parse", "bad_alloc"})
            if (words.find(part) != std::string_view::npos)
                return true;
        return false;
    }

    std::string m_first, m_change;
};

std::string startOf(const fs::path& path, std::size_t size)
{
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

/// Throws FileError for an FBX version that Assimp does not read.
void requireFbxVersion(const fs::path& path, std::string_view start)
{
    constexpr int oldest = 7100;
    const int version = fbxVersion(start);
    if (version == 0 || version >= oldest)
        return;
    core::FileError error(core::FileErrorKind::Malformed, path);
    error.fault = core::FileFault::OldFbx;
    error.token = std::to_string(version / 1000) + "." + std::to_string(version / 100 % 10);
    throw error;
}

/// Throws FileError for an IFC schema of which Assimp reads little.
void requireIfcSchema(const fs::path& path, std::string_view start)
{
    constexpr std::string_view keyword = "FILE_SCHEMA", letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    constexpr std::size_t longest = 40;
    std::string_view schema = start.substr(std::min(start.find(keyword), start.size()));
    schema.remove_prefix(std::min(schema.find('\''), schema.size()));
    schema = schema.substr(std::min<std::size_t>(1, schema.size()));
    schema = schema.substr(0, std::min(schema.find_first_not_of(letters), longest));
    if (schema.empty() || schema.starts_with("IFC2X"))
        return;
    core::FileError error(core::FileErrorKind::Malformed, path);
    error.fault = core::FileFault::OtherIfc;
    error.token = schema;
    throw error;
}

/// Throws FileError if the message is about a number. Assimp then quotes all text from the wrong word on, with "?" for
/// each byte that is not printable; that text shows the place in the file.
void requireNumber(const fs::path& path, std::string_view words)
{
    constexpr std::string_view begin = "Cannot parse string \"", end = "\" as a real number";
    const std::size_t last = words.rfind(end);
    if (!words.starts_with(begin) || last == std::string_view::npos)
        return;
    const std::string_view quoted = words.substr(begin.size(), last - begin.size());
    if (quoted.empty()) {
        core::FileError error(core::FileErrorKind::ReaderRefused, path);
        error.token = "a number is missing";
        throw error;
    }
    const std::string bytes = startOf(path, fs::file_size(path));
    std::string printable = bytes;
    std::ranges::replace_if(
        printable, [](char c) { return c < ' ' || c > '~'; }, '?');
    const std::size_t at = printable.rfind(quoted);
    if (at == std::string::npos || printable.find(quoted) != at) // the text is changed, or occurs twice
        throw core::io::errorWithToken(core::FileErrorKind::NotANumber, {path, {}},
                                       quoted.substr(0, quoted.find_first_of(" ?")));
    const std::string_view rest = std::string_view(bytes).substr(at);
    throw core::io::errorAtLine(core::FileErrorKind::NotANumber, {path, bytes}, bytes.data() + at,
                                rest.substr(0, rest.find_first_of(" \t\r\n<\"")));
}

/// Returns whether Assimp reads files with this extension as XML.
bool isXml(const fs::path& path)
{
    const std::string ending = lowerEnding(path);
    return ending == ".dae" || ending == ".irrmesh" || ending == ".xgl";
}

/// Reports why Assimp has read nothing.
int refuseUnread(const Assimp::Importer& importer, const ImportFolder::Notes& notes, const fs::path& path)
{
    if (lowerEnding(path) == ".ifc")
        requireIfcSchema(path, startOf(path, startSize));
    if (!notes.outside.empty())
        return refuse(ImportHeader::Outcome::Outside, notes.outside);
    if (isXml(path)) {
        const std::string bytes = startOf(path, fs::file_size(path));
        requireXml({path, bytes});
    }
    requireNumber(path, importer.GetErrorString());
    return refuse(ImportHeader::Outcome::Refused, wordsOf(importer, path));
}

/// Adds information about the file other than its mesh to the header.
void addNotes(const aiScene& scene, const ImportFolder::Notes& notes, const fs::path& path, ImportHeader& header)
{
    for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
        const aiAnimation& animation = *scene.mAnimations[i];
        const bool moves = animation.mNumChannels + animation.mNumMeshChannels + animation.mNumMorphMeshChannels > 0;
        header.animations += moves ? 1 : 0;
    }
    header.hiddenObjects = notes.hidden;
    header.unreadNodes = notes.unread + notes.missing.size();
    if (lowerEnding(path) != ".fbx")
        return;
    const std::string bytes = startOf(path, fs::file_size(path));
    header.subdivisions = fbxSubdivisions(bytes);
    header.unreadNodes += fbxNurbs(bytes);
}

/// Returns the name of a node, or nothing if Assimp invented it for a node without one.
std::string_view givenName(std::string_view name)
{
    return name.starts_with("$ColladaAutoName$") || name.starts_with('<') ? std::string_view() : name;
}

/// Reads a format that core reads, in this process because only it has the Draco decoder.
int importOwn(const fs::path& path, const ImportLimits& limits, bool keepsObjects)
{
    // stacks and heaps of further threads would count against this process's memory limit
    core::WorkerPool::shared().setThreads(1);
    core::setDracoDecoder(decodedDraco);
    const core::ReadResult result = core::readModel(path, {.up = core::UpAxis::Y, .keepsObjects = keepsObjects});
    if (result.mesh.points.size() > limits.points || result.mesh.triangles.size() > limits.triangles)
        throw std::bad_alloc();
    ImportHeader header;
    header.outcome = ImportHeader::Outcome::Read;
    header.objects = result.remarks.objects;
    header.repeatedCorners = result.remarks.repeatedCorners;
    header.facesOfFewer = result.remarks.facesOfFewer;
    header.materials = result.remarks.materials;
    header.textures = result.remarks.textures;
    header.poses = result.remarks.poses;
    header.hiddenObjects = result.remarks.hiddenObjects;
    return sendResult(header, result.mesh, result.parts);
}

int importForeign(const fs::path& path, const ImportLimits& limits, bool keepsObjects)
{
    const std::string start = startOf(path, startSize);
    const bool isFbx = lowerEnding(path) == ".fbx";
    if (isFbx)
        requireFbxVersion(path, start);
    ImportFolder::Notes notes;
    const ErrorLog& log = ErrorLog::attached();
    Assimp::Importer importer;
    // owned by the importer from now on
    importer.SetIOHandler(new ImportFolder(fs::canonical(path.parent_path()), notes));
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true); // they stand for nodes without meshes
    const aiScene* const scene = importer.ReadFile(path.string(), 0);
    if (notes.problem)
        std::rethrow_exception(notes.problem);
    if (!scene || !scene->mRootNode)
        return refuseUnread(importer, notes, path);
    if (!log.change().empty())
        return refuse(ImportHeader::Outcome::Refused, log.change());
    if (!notes.isFollowed) // the unmodified file might be read with wrong rotations
        return refuse(ImportHeader::Outcome::Refused, "the records of its models cannot be followed");
    SceneMesh mesh(*scene, limits, keepsObjects);
    FbxLeftOut left;
    if (isFbx)
        left = addFbxScene(*scene, notes.models, mesh);
    else
        mesh.addAll(unitOf(path), lowerEnding(path) == ".x3d" ? core::io::x3dNameIn : givenName);
    if (mesh.faces() == 0 && !notes.outside.empty())
        return refuse(ImportHeader::Outcome::Outside, notes.outside);
    if (mesh.faces() == 0 && notes.whyEmpty)
        throw *notes.whyEmpty;
    if (mesh.faces() == 0 && !notes.missing.empty())
        throw core::io::malformed(core::FileFault::Missing,
                                  core::io::errorWithToken({}, {path, {}}, *notes.missing.begin()));
    if (mesh.faces() == 0 && (left.missing > 0 || !log.first().empty()))
        return refuse(ImportHeader::Outcome::Refused, log.first().empty() ? "its meshes are broken" : log.first());
    ImportHeader header;
    header.outcome = ImportHeader::Outcome::Read;
    const core::TriangleMesh result = mesh.take(header);
    addNotes(*scene, notes, path, header);
    header.unreadNodes += left.missing;
    header.hiddenObjects += left.hidden;
    return sendResult(header, result, mesh.parts());
}
} // namespace

bool assimpHoldsUnit(const fs::path& file)
{
    return holdsUnit(file);
}

int runImport(const fs::path& file, const char* bytes, const char* objects)
{
    const fs::path path = fs::absolute(file);
    try {
        const ImportLimits limits(
            static_cast<std::uint64_t>(std::max<std::int64_t>(core::io::parseInteger(bytes).value_or(0), 0)));
        limitOwnProcess(limits.memory, limits.seconds);
        const bool keepsObjects = std::string_view(objects) == importAsParts;
        return core::meshFormatOf(path) ? importOwn(path, limits, keepsObjects)
                                        : importForeign(path, limits, keepsObjects);
    } catch (const std::bad_alloc&) {
        return refuse(ImportHeader::Outcome::OutOfMemory, {});
    } catch (const core::FileError& error) {
        return refuse(error, path);
    } catch (const std::exception& problem) {
        return refuse(ImportHeader::Outcome::Refused, problem.what());
    }
}
} // namespace app
