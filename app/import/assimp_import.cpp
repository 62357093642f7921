#include "app/import/assimp_import.h"

#include "app/import/import_protocol.h"
#include "app/platform/resource_limits.h"

#include "core/geometry/triangle_mesh.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
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

/// Millimetres in the unit of what Assimp gives, and Z made Y where it leaves that to us.
Eigen::Matrix4d placeOf(const aiScene& scene, const std::string& ending)
{
    double unit = 1;
    Eigen::Matrix4d place = Eigen::Matrix4d::Identity();
    if (ending == ".fbx") {
        float centimetres = 1;
        std::int32_t up = 1;
        if (scene.mMetaData) {
            scene.mMetaData->Get("UnitScaleFactor", centimetres);
            scene.mMetaData->Get("UpAxis", up);
        }
        unit = 10 * static_cast<double>(centimetres);
        if (up == 2)
            place << 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1;
    }
    for (const std::string_view inMetres : endingsInMetres)
        unit = ending == inMetres ? 1000 : unit;
    place.topRows<3>() *= unit;
    return place;
}

class SceneReader
{
public:
    SceneReader(const aiScene& scene, const ImportLimits& limits) : m_scene(scene), m_limits(limits) {}

    void add(const aiNode& node, const Eigen::Matrix4d& above)
    {
        Eigen::Matrix4d own;
        for (unsigned row = 0; row < 4; ++row)
            for (unsigned column = 0; column < 4; ++column)
                own(row, column) = static_cast<double>(node.mTransformation[row][column]);
        const Eigen::Matrix4d transform = above * own;
        const std::size_t before = mesh.triangles.size();
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            addMesh(*m_scene.mMeshes[node.mMeshes[i]], transform);
        header.objects += mesh.triangles.size() > before ? 1 : 0;
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            add(*node.mChildren[i], transform);
    }

    void addRemarks()
    {
        header.objects = std::max<std::uint64_t>(header.objects, 1);
        header.materials = m_scene.mNumMaterials > 1;
        header.textures = m_scene.mNumTextures > 0;
        for (unsigned i = 0; i < m_scene.mNumMaterials; ++i)
            for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR})
                header.textures = header.textures || m_scene.mMaterials[i]->GetTextureCount(type) > 0;
        for (unsigned i = 0; i < m_scene.mNumMeshes; ++i)
            header.poses = header.poses || m_scene.mMeshes[i]->HasBones() || m_scene.mMeshes[i]->mNumAnimMeshes > 0;
    }

    core::TriangleMesh mesh;
    ImportHeader header{.objects = 0};

private:
    void addMesh(const aiMesh& from, const Eigen::Matrix4d& transform)
    {
        if (mesh.points.size() + from.mNumVertices > m_limits.points ||
            mesh.triangles.size() + from.mNumFaces > m_limits.triangles)
            throw std::bad_alloc();
        const auto first = static_cast<core::Slot>(mesh.points.size());
        for (unsigned i = 0; i < from.mNumVertices; ++i) {
            const aiVector3D& p = from.mVertices[i];
            mesh.points.push_back((transform * Eigen::Vector4d(p.x, p.y, p.z, 1)).head<3>().cast<float>());
        }
        if (from.HasVertexColors(0)) {
            mesh.colors.resize(first);
            for (unsigned i = 0; i < from.mNumVertices; ++i)
                mesh.colors.push_back(colorOf(from.mColors[0][i]));
        }
        const bool isMirrored = transform.topLeftCorner<3, 3>().determinant() < 0;
        for (unsigned i = 0; i < from.mNumFaces; ++i) {
            const aiFace& face = from.mFaces[i];
            if (face.mNumIndices == 3)
                mesh.triangles.push_back({first + face.mIndices[0], first + face.mIndices[isMirrored ? 2 : 1],
                                          first + face.mIndices[isMirrored ? 1 : 2]});
        }
    }

    static core::Rgb colorOf(const aiColor4D& color)
    {
        const auto byte = [](float x) {
            return static_cast<std::uint8_t>(std::lround(255 * std::clamp(std::isnan(x) ? 0 : x, 0.0F, 1.0F)));
        };
        return {byte(color.r), byte(color.g), byte(color.b)};
    }

    const aiScene& m_scene;
    const ImportLimits& m_limits;
};

bool send(const void* data, std::size_t size)
{
    return size == 0 || std::fwrite(data, 1, size, stdout) == size; // data may be null then
}

template <class Element> bool send(const std::vector<Element>& elements)
{
    return send(elements.data(), elements.size() * sizeof(Element));
}

int sendResult(ImportHeader header, core::TriangleMesh mesh)
{
    if (!mesh.colors.empty())
        mesh.colors.resize(mesh.points.size());
    header.points = mesh.points.size();
    header.colors = mesh.colors.size();
    header.triangles = mesh.triangles.size();
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
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    const aiScene* const scene = importer.ReadFile(path.string(), aiProcess_Triangulate);
    if (!scene || !scene->mRootNode)
        return outside.empty() ? refuse(ImportHeader::Outcome::Refused, importer.GetErrorString())
                               : refuse(ImportHeader::Outcome::Outside, outside);
    SceneReader reader(*scene, limits);
    reader.add(*scene->mRootNode, placeOf(*scene, lowerEnding(path)));
    if (reader.mesh.triangles.empty() && !outside.empty())
        return refuse(ImportHeader::Outcome::Outside, outside);
    reader.addRemarks();
    reader.header.outcome = ImportHeader::Outcome::Read;
    return sendResult(reader.header, std::move(reader.mesh));
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
