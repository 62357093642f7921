#pragma once

#include "app/import/import_protocol.h"

#include "core/geometry/triangle_mesh.h"
#include "core/io/mesh/polygons.h"

#include <Eigen/Core>

struct aiMesh;
struct aiNode;
struct aiScene;

namespace app
{
/// Gathers the meshes of a scene that Assimp has read as one mesh, in millimetres. Polygons come whole and are cut into
/// triangles by core's exact code.
class SceneMesh
{
public:
    SceneMesh(const aiScene& scene, const ImportLimits& limits) : m_scene(scene), m_limits(limits) {}

    /// Adds the meshes of the node, without its children's. `countsFewer`: whether faces of fewer than three corners,
    /// which are left out, are polygons, to be counted, and not points and lines. Throws std::bad_alloc beyond the
    /// limits, and std::runtime_error where a face names a point that is not there.
    void addMeshesOf(const aiNode& node, const Eigen::Matrix4d& transform, bool countsFewer = false);
    /// Adds the node with all below it. `above`: the transform of its parent.
    void addTree(const aiNode& node, const Eigen::Matrix4d& above);

    /// Counts the polygons that have been added.
    std::size_t faces() const { return m_polygons.faces(); }
    /// Returns the mesh, and puts its counts and remarks into the header. Empties this.
    core::TriangleMesh take(ImportHeader& header);

private:
    void addMesh(const aiMesh& from, const Eigen::Matrix4d& transform, bool countsFewer);
    void addColors(const aiMesh& from, std::size_t first);
    void addFaces(const aiMesh& from, core::Slot first, bool isMirrored, bool countsFewer);
    bool hasTextures() const;

    const aiScene& m_scene;
    const ImportLimits& m_limits;
    core::TriangleMesh m_mesh; ///< its points and colours
    core::io::Polygons m_polygons;
    std::uint64_t m_objects = 0, m_facesOfFewer = 0;
};

/// Returns the node's own transform.
Eigen::Matrix4d matrixOf(const aiNode& node);
} // namespace app
