#include "app/import/assimp_import.h"

#include "app/import/fbx_scene.h"
#include "app/import/import_protocol.h"
#include "app/import/scene_mesh.h"
#include "app/platform/resource_limits.h"

#include "core/geometry/triangle_mesh.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>

namespace app
{
namespace
{
namespace fs = std::filesystem;

/// Lets Assimp read in one folder, links followed, and write nowhere. What it asks for elsewhere is noted in `outside`,
/// by name.
class OneFolder : public Assimp::DefaultIOSystem
{
public:
    OneFolder(fs::path folder, std::string& outside) : m_folder(std::move(folder)), m_outside(outside) {}

    bool Exists(const char* file) const override { return isWithin(file) && DefaultIOSystem::Exists(file); }
    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        const bool reads = std::strchr(mode, 'r') && !std::strchr(mode, '+');
        return reads && isWithin(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
    }

private:
    bool isWithin(const char* file) const
    {
        std::error_code problem;
        const fs::path path = fs::canonical(file, problem);
        if (problem)
            return false;
        const bool isWithin =
            std::mismatch(m_folder.begin(), m_folder.end(), path.begin(), path.end()).first == m_folder.end();
        if (!isWithin)
            m_outside = fs::path(file).filename().string();
        return isWithin;
    }

    fs::path m_folder;
    std::string& m_outside;
};

std::string lowerEnding(const fs::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

/// As their specifications have it.
constexpr std::string_view endingsInMetres[] = {".dae", ".zae", ".x3d", ".x3db", ".lwo", ".ifc"};

/// Returns the millimetres in the unit of what Assimp gives.
Eigen::Matrix4d placeOf(const std::string& ending)
{
    double unit = 1;
    for (const std::string_view inMetres : endingsInMetres)
        unit = ending == inMetres ? 1000 : unit;
    return Eigen::Vector4d(unit, unit, unit, 1).asDiagonal();
}

bool send(const void* data, std::size_t size)
{
    return size == 0 || std::fwrite(data, 1, size, stdout) == size; // data may be null then
}

template <class Element> bool send(const std::vector<Element>& elements)
{
    return send(elements.data(), elements.size() * sizeof(Element));
}

int sendResult(const ImportHeader& header, const core::TriangleMesh& mesh)
{
    const bool isSent = send(&header, sizeof header) && send(mesh.points) && send(mesh.colors) &&
                        send(mesh.triangles) && send(&importEnd, sizeof importEnd) && std::fflush(stdout) == 0;
    return isSent ? 0 : 1;
}

int refuse(ImportHeader::Outcome outcome, std::string_view message)
{
    ImportHeader header;
    header.outcome = message.find("bad_alloc") != std::string_view::npos ? ImportHeader::Outcome::OutOfMemory : outcome;
    std::copy_n(message.begin(), std::min(message.size(), sizeof header.message - 1), header.message);
    return sendResult(header, {});
}

int import(const fs::path& path, const ImportLimits& limits)
{
    std::string outside;
    Assimp::Importer importer;
    importer.SetIOHandler(new OneFolder(fs::canonical(path.parent_path()), outside)); // the importer's from now on
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
    const aiScene* const scene = importer.ReadFile(path.string(), 0);
    if (!scene || !scene->mRootNode)
        return outside.empty() ? refuse(ImportHeader::Outcome::Refused, importer.GetErrorString())
                               : refuse(ImportHeader::Outcome::Outside, outside);
    SceneMesh mesh(*scene, limits);
    const std::string ending = lowerEnding(path);
    if (ending == ".fbx")
        addFbxScene(*scene, mesh);
    else
        mesh.addTree(*scene->mRootNode, placeOf(ending));
    if (mesh.isEmpty() && !outside.empty())
        return refuse(ImportHeader::Outcome::Outside, outside);
    ImportHeader header;
    header.outcome = ImportHeader::Outcome::Read;
    const core::TriangleMesh result = mesh.take(header);
    return sendResult(header, result);
}
} // namespace

bool assimpHoldsUnit(const fs::path& file)
{
    const std::string ending = lowerEnding(file);
    return ending == ".fbx" || std::ranges::find(endingsInMetres, ending) != std::end(endingsInMetres);
}

int runImport(const char* file)
{
    try {
        const fs::path path = fs::absolute(file);
        const ImportLimits limits(fs::file_size(path));
        limitOwnProcess(limits.memory, limits.seconds);
        return import(path, limits);
    } catch (const std::bad_alloc&) {
        return refuse(ImportHeader::Outcome::OutOfMemory, {});
    } catch (const std::exception& problem) {
        return refuse(ImportHeader::Outcome::Refused, problem.what());
    }
}
} // namespace app
