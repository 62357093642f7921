// Feeds arbitrary bytes to the reader of the format that FETTLE_FORMAT names (stl, obj, …). The reader must return a
// mesh as core/io/mesh_io.h promises, or throw a FileError.
// "brush": the preset reader (core/io/stroke/brush_file.h), which throws StrokeFileError.
// "x3d", "fbx", "dae": the preparation of such files for Assimp (core/io/mesh/x3d_expansion.h, app/import/fbx_models.h,
// app/import/collada_check.h).
// Draco streams are not decoded: a substitute decoder derives a mesh from their bytes, as a faulty decoder might.
#include "app/import/collada_check.h"
#include "app/import/fbx_file.h"
#include "app/import/fbx_models.h"
#include "core/io/draco_stream.h"
#include "core/io/mesh/x3d_expansion.h"
#include "core/io/mesh_io.h"
#include "core/io/stroke/brush_file.h"
#include "core/util/file_error.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>

namespace
{
/// A temporary folder of this process. A glTF file can refer to other files in its folder, so none may be there.
class Folder
{
public:
    Folder() : m_path(std::filesystem::temp_directory_path() / ("fettle_fuzz_" + std::to_string(getpid())))
    {
        const char* format = std::getenv("FETTLE_FORMAT");
        if (!format) {
            std::fputs("FETTLE_FORMAT does not say which reader\n", stderr);
            std::exit(2);
        }
        m_name += format;
        std::filesystem::create_directory(m_path);
    }
    ~Folder() { std::filesystem::remove_all(m_path); }

    bool isOfBrushes() const { return m_name == "model.brush"; }
    bool isOfCollada() const { return m_name == "model.dae"; }
    bool isOfFbx() const { return m_name == "model.fbx"; }
    bool isOfX3d() const { return m_name == "model.x3d"; }
    std::filesystem::path file() const { return m_path / m_name; }

private:
    std::filesystem::path m_path;
    std::string m_name = "model.";
};

void require(bool holds, const char* what)
{
    if (holds)
        return;
    std::fprintf(stderr, "the reader's promise is broken: %s\n", what);
    std::abort();
}

void check(const core::TriangleMesh& mesh)
{
    require(!mesh.triangles.empty(), "at least one face");
    require(mesh.colors.empty() || mesh.colors.size() == mesh.points.size(), "a colour for each point, or none");
    for (const core::Vec3f& p : mesh.points)
        require(p.allFinite(), "finite points");
    for (const core::Triangle& t : mesh.triangles)
        for (const core::Slot v : t)
            require(v < mesh.points.size(), "indices in range");
}

/// Checks that a preset is in range, and that writing and reading it gives an equal preset.
void checkBrush(std::string_view text)
{
    try {
        const core::BrushPreset preset = core::parseBrush(text);
        require(!preset.name.empty() && preset.name.size() <= core::maxPresetName, "a name");
        require(core::isFalloff(preset.stroke.falloff), "a falloff");
        require(preset.stroke.strength >= 0 && preset.stroke.strength <= 10, "a strength");
        const std::string written = core::toJson(preset);
        require(core::toJson(core::parseBrush(written)) == written, "what is written is read");
    } catch (const core::StrokeFileError&) {
    }
}

/// Checks that an expanded X3D file can be expanded again, which must not change it.
void checkX3d(const std::filesystem::path& path, std::string_view text)
{
    try {
        const core::io::X3dExpansion expansion = core::io::expandX3d({path, text});
        const core::io::X3dExpansion again = core::io::expandX3d({path, expansion.text});
        require(again.text == expansion.text && again.unread == 0, "what is expanded stays as it is");
    } catch (const core::FileError&) {
    }
}

/// Checks that the two checks of a COLLADA file throw what they say.
void checkCollada(const std::filesystem::path& path, std::string_view text)
{
    try {
        app::requireSoundCollada({path, text});
    } catch (const core::FileError& error) {
        require(error.fault != core::FileFault::XmlSyntax, "broken XML is left to requireXml()");
    }
    try {
        app::requireXml({path, text});
    } catch (const core::FileError& error) {
        require(error.fault == core::FileFault::XmlSyntax, "an error in the XML");
    }
}

/// Checks that no model below `index` contains itself, and that all indices are in range.
void checkBelow(const std::vector<app::FbxModel>& models, std::size_t index, std::vector<bool>& isOnWay,
                std::vector<bool>& isDone)
{
    isOnWay[index] = true;
    for (const std::size_t child : models[index].below) {
        require(child > 0 && child < models.size(), "indices of models in range");
        require(!isOnWay[child], "no model that holds itself");
        if (!isDone[child])
            checkBelow(models, child, isOnWay, isDone);
    }
    isOnWay[index] = false;
    isDone[index] = true;
}

/// Checks that the FBX file prepared for Assimp has as many models as the original.
void checkFbx(const std::filesystem::path& path, std::string_view bytes)
{
    app::fbxVersion(bytes);
    app::fbxSubdivisions(bytes);
    app::fbxNurbs(bytes);
    try {
        const app::FbxForAssimp fbx = app::fbxForAssimp(path, bytes);
        require(fbx.isFollowed != fbx.models.empty(), "the scene, where it was followed");
        if (!fbx.models.empty()) {
            std::vector<bool> isOnWay(fbx.models.size()), isDone(fbx.models.size());
            checkBelow(fbx.models, 0, isOnWay, isDone);
        }
        if (!fbx.changed)
            return;
        const app::FbxForAssimp again = app::fbxForAssimp(path, *fbx.changed);
        require(again.isFollowed && again.models.size() == fbx.models.size(), "what was changed is followed");
    } catch (const core::FileError&) {
    }
}

/// Returns a mesh whose counts, types and corners are taken from the bytes of the stream.
std::optional<core::DracoMesh> decodedByBytes(std::string_view stream, std::span<const std::uint32_t> ids)
{
    std::size_t at = 0;
    const auto next = [&] { return at < stream.size() ? static_cast<unsigned char>(stream[at++]) : 0U; };
    if (next() == 0)
        return std::nullopt;
    core::DracoMesh mesh{.vertices = next(), .corners = {}, .attributes = {}};
    for (const std::uint32_t id : ids) {
        core::DracoMesh::Attribute attribute{.id = id, .componentType = 5120 + static_cast<int>(next() % 8)};
        attribute.components = static_cast<int>(next() % 5);
        attribute.bytes.assign(mesh.vertices * static_cast<std::size_t>(attribute.components) * (next() % 5), '\1');
        mesh.attributes.push_back(attribute);
    }
    while (at < stream.size())
        mesh.corners.push_back(next());
    return mesh;
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    static const Folder folder;
    static const bool hasDecoder = (core::setDracoDecoder(decodedByBytes), true);
    static_cast<void>(hasDecoder);
    if (folder.isOfBrushes()) {
        checkBrush({reinterpret_cast<const char*>(data), size});
        return 0;
    }
    if (folder.isOfCollada()) {
        checkCollada(folder.file(), {reinterpret_cast<const char*>(data), size});
        return 0;
    }
    if (folder.isOfFbx()) {
        checkFbx(folder.file(), {reinterpret_cast<const char*>(data), size});
        return 0;
    }
    if (folder.isOfX3d()) {
        checkX3d(folder.file(), {reinterpret_cast<const char*>(data), size});
        return 0;
    }
    std::ofstream(folder.file(), std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    try {
        check(core::readMesh(folder.file()));
        core::readMetadata(folder.file());
    } catch (const core::FileError&) {
    }
    return 0;
}
