#include "app/import/scene_mesh.h"

#include <assimp/scene.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

namespace app
{
namespace
{
std::string_view wordsOf(const aiString& text)
{
    return {text.C_Str(), text.length};
}

core::Rgb colorOf(const aiColor4D& color)
{
    const auto byte = [](float x) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(std::isnan(x) ? 0 : x, 0.0F, 1.0F)));
    };
    return {byte(color.r), byte(color.g), byte(color.b)};
}
} // namespace

Eigen::Matrix4d matrixOf(const aiNode& node)
{
    Eigen::Matrix4d matrix;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            matrix(row, column) = static_cast<double>(node.mTransformation[row][column]);
    return matrix;
}

void SceneMesh::addAll(double unit, NameInFile nameInFile)
{
    const Eigen::Matrix4d scale = Eigen::Vector4d(unit, unit, unit, 1).asDiagonal();
    addTree(*m_scene.mRootNode, scale, nameInFile, {});
}

void SceneMesh::addTree(const aiNode& node, const Eigen::Matrix4d& above, NameInFile nameInFile,
                        std::string_view nameAbove)
{
    const Eigen::Matrix4d transform = above * matrixOf(node);
    const std::string_view own = nameInFile ? nameInFile(wordsOf(node.mName)) : wordsOf(node.mName);
    const std::string_view name = own.empty() ? nameAbove : own;
    addMeshesOf(node, transform, name);
    const bool isRoot = &node == m_scene.mRootNode;
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        addTree(*node.mChildren[i], transform, nameInFile, isRoot ? std::string_view() : name);
}

void SceneMesh::addMeshesOf(const aiNode& node, const Eigen::Matrix4d& transform, std::string_view name,
                            bool countsFewer)
{
    if (node.mNumMeshes == 0)
        return;
    const std::size_t before = m_polygons.faces();
    m_labels.begin(name.empty() ? wordsOf(m_scene.mMeshes[node.mMeshes[0]]->mName) : name);
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
        addMesh(*m_scene.mMeshes[node.mMeshes[i]], transform, countsFewer);
    m_labels.label(m_mesh);
    m_objects += m_polygons.faces() > before ? 1 : 0;
}

void SceneMesh::addMesh(const aiMesh& from, const Eigen::Matrix4d& transform, bool countsFewer)
{
    if (m_mesh.points.size() + from.mNumVertices > m_limits.points)
        throw std::bad_alloc();
    const auto first = static_cast<core::Slot>(m_mesh.points.size());
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        const aiVector3D& p = from.mVertices[i];
        m_mesh.points.push_back((transform * Eigen::Vector4d(p.x, p.y, p.z, 1)).head<3>().cast<float>());
    }
    addColors(from, first);
    addFaces(from, first, transform.topLeftCorner<3, 3>().determinant() < 0, countsFewer);
}

void SceneMesh::addColors(const aiMesh& from, std::size_t first)
{
    if (!from.HasVertexColors(0))
        return;
    m_mesh.colors.resize(first);
    for (unsigned i = 0; i < from.mNumVertices; ++i)
        m_mesh.colors.push_back(colorOf(from.mColors[0][i]));
}

/// Skips points and lines, which Assimp represents as faces, too.
void SceneMesh::addFaces(const aiMesh& from, core::Slot first, bool isMirrored, bool countsFewer)
{
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        const unsigned corners = face.mNumIndices;
        if (corners < 3) {
            m_facesOfFewer += countsFewer ? 1 : 0;
            continue;
        }
        if (corners > core::io::maxCorners)
            throw std::bad_alloc();
        for (unsigned k = 0; k < corners; ++k) {
            const unsigned corner = face.mIndices[isMirrored ? corners - 1 - k : k];
            if (corner >= from.mNumVertices)
                throw std::runtime_error("a face names a point that is not there");
            m_polygons.addCorner(first + corner);
        }
        m_polygons.endFace();
        if (m_polygons.corners() - 2 * m_polygons.faces() > m_limits.triangles)
            throw std::bad_alloc();
    }
}

bool SceneMesh::hasTextures() const
{
    bool hasAny = m_scene.mNumTextures > 0;
    for (unsigned i = 0; i < m_scene.mNumMaterials; ++i)
        for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR})
            hasAny = hasAny || m_scene.mMaterials[i]->GetTextureCount(type) > 0;
    return hasAny;
}

core::TriangleMesh SceneMesh::take(ImportHeader& header)
{
    core::ReadRemarks remarks;
    m_mesh.triangles = m_polygons.triangles(m_mesh.points, core::io::StopCheck({}), remarks);
    if (!m_mesh.colors.empty())
        m_mesh.colors.resize(m_mesh.points.size());
    m_polygons = {};
    m_parts = m_labels.finish(m_mesh);
    header.objects = std::max<std::uint64_t>(m_objects, 1);
    header.repeatedCorners = remarks.repeatedCorners;
    header.facesOfFewer = m_facesOfFewer + remarks.facesOfFewer;
    header.materials = m_scene.mNumMaterials > 1;
    header.textures = hasTextures();
    for (unsigned i = 0; i < m_scene.mNumMeshes; ++i)
        header.poses = header.poses || m_scene.mMeshes[i]->HasBones() || m_scene.mMeshes[i]->mNumAnimMeshes > 0;
    return std::move(m_mesh);
}
} // namespace app
