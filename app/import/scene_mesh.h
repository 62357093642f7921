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
/// Merges the meshes of a scene read by Assimp into one mesh, in millimetres. Polygons are kept whole and triangulated
/// by core's exact code.
class SceneMesh
{
public:
    SceneMesh(const aiScene& scene, const ImportLimits& limits) : m_scene(scene), m_limits(limits) {}

    /// Adds the meshes of the node, not those of its children. Faces with fewer than three corners are skipped;
    /// `countsFewer`: whether they are counted as polygons rather than ignored as points and lines. Throws
    /// std::bad_alloc beyond the limits, and std::runtime_error if a face refers to a missing point.
    void addMeshesOf(const aiNode& node, const Eigen::Matrix4d& transform, bool countsFewer = false);
    /// Adds the node and all its descendants. `above`: transform of the node's parent.
    void addTree(const aiNode& node, const Eigen::Matrix4d& above);

    /// Returns the number of polygons added.
    std::size_t faces() const { return m_polygons.faces(); }
    /// Returns the mesh and writes its counts and remarks to the header. Empties this object.
    core::TriangleMesh take(ImportHeader& header);

private:
    void addMesh(const aiMesh& from, const Eigen::Matrix4d& transform, bool countsFewer);
    void addColors(const aiMesh& from, std::size_t first);
    void addFaces(const aiMesh& from, core::Slot first, bool isMirrored, bool countsFewer);
    bool hasTextures() const;

    const aiScene& m_scene;
    const ImportLimits& m_limits;
    core::TriangleMesh m_mesh; ///< points and colours only, until take() adds triangles
    core::io::Polygons m_polygons;
    std::uint64_t m_objects = 0, m_facesOfFewer = 0;
};

/// Returns the node's own transform, without its parents'.
Eigen::Matrix4d matrixOf(const aiNode& node);
} // namespace app
