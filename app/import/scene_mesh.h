#pragma once

#include "app/import/import_protocol.h"

#include "core/geometry/triangle_mesh.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/polygons.h"

#include <Eigen/Core>

struct aiMesh;
struct aiNode;
struct aiScene;

namespace app
{
/// Merges the meshes of a scene read by Assimp into one mesh, in millimetres. The meshes of a node are one object.
/// Polygons are kept whole and triangulated by core's exact code.
class SceneMesh
{
public:
    /// `keepsObjects`: whether a part is made of each object, as by core::ReadOptions.
    SceneMesh(const aiScene& scene, const ImportLimits& limits, bool keepsObjects)
        : m_scene(scene)
        , m_limits(limits)
        , m_labels(keepsObjects)
    {}

    /// Adds the meshes of the node, not those of its children, as an object with this name. Faces with fewer than three
    /// corners are skipped; `countsFewer`: whether they are counted as polygons rather than ignored as points and
    /// lines. Throws std::bad_alloc beyond the limits, and std::runtime_error if a face refers to a missing point.
    void addMeshesOf(const aiNode& node, const Eigen::Matrix4d& transform, std::string_view name,
                     bool countsFewer = false);
    /// Returns the name that a node has in the file, given the name that Assimp has for it.
    using NameInFile = std::string_view (*)(std::string_view name);
    /// Adds all nodes of the scene. A node without a name has that of the nearest node above it, except the root, or
    /// else that of its first mesh. `unit`: millimetres in one unit of the scene. `nameInFile`: null if the names are
    /// the file's.
    void addAll(double unit, NameInFile nameInFile = nullptr);

    /// Returns the number of polygons added.
    std::size_t faces() const { return m_polygons.faces(); }
    /// Returns the mesh and writes its remarks to the header. Empties this object.
    core::TriangleMesh take(ImportHeader& header);
    /// Returns the parts of the mesh that take() returned.
    const core::PartList& parts() const { return m_parts; }

private:
    void addTree(const aiNode& node, const Eigen::Matrix4d& above, NameInFile nameInFile, std::string_view nameAbove);
    void addMesh(const aiMesh& from, const Eigen::Matrix4d& transform, bool countsFewer);
    void addColors(const aiMesh& from, std::size_t first);
    void addFaces(const aiMesh& from, core::Slot first, bool isMirrored, bool countsFewer);
    bool hasTextures() const;

    const aiScene& m_scene;
    const ImportLimits& m_limits;
    core::TriangleMesh m_mesh; ///< points, colours and labels only, until take() adds triangles
    core::io::Polygons m_polygons;
    core::io::ObjectLabels m_labels;
    core::PartList m_parts;
    std::uint64_t m_objects = 0, m_facesOfFewer = 0;
};

/// Returns the node's own transform, without its parents'.
Eigen::Matrix4d matrixOf(const aiNode& node);
} // namespace app
