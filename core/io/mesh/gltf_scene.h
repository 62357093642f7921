#pragma once

#include "core/io/mesh/gltf_document.h"

#include <Eigen/Core>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace core::io
{
/// The placement of a mesh in a scene.
struct GltfPlace
{
    Eigen::Matrix4d transform; ///< transform from the mesh to the scene; not used for vertices bound to joints
    /// Transforms from a skinned mesh to the scene, one for each joint; empty without a skin. Valid as long as the
    /// GltfScene exists.
    std::span<const Eigen::Matrix4d> joints;
    std::string_view name = {}; ///< name of the node; may be empty
};

/// Visits the visible nodes of a glTF's scene, and their instances. Without scenes it visits all nodes that have no
/// parent; without nodes, too, all meshes untransformed.
class GltfScene
{
public:
    /// `file`, `document`, `stopCheck`: not owned.
    GltfScene(const FileBytes& file, const GltfDocument& document, StopCheck& stopCheck)
        : m_file(file)
        , m_gltf(document)
        , m_stopCheck(stopCheck)
    {}

    /// Calls `visit` for each use of a mesh in the scene. Placements are in the space that `root` transforms to. Joints
    /// have the transforms of their nodes. Throws FileError and ReadingCancelled.
    using Visit = std::function<void(std::size_t mesh, const GltfPlace& place)>;
    void forEachMesh(const Eigen::Matrix4d& root, const Visit& visit);
    /// Returns the number of nodes with meshes that forEachMesh() did not visit, and of meshes without any node. Levels
    /// of detail (MSFT_lod) do not count.
    std::size_t hiddenObjects() const;

private:
    using Json = GltfDocument::Json;

    bool hasScene() const;
    std::vector<std::size_t> rootNodes() const;
    std::vector<std::optional<std::size_t>> parents() const;
    void visitNode(std::size_t index, const Eigen::Matrix4d& above, int depth, const Visit& visit);
    void visitInstances(const Json& node, const Eigen::Matrix4d& transform, const Visit& visit);
    std::span<const Eigen::Matrix4d> jointsOf(std::size_t skin);
    const Eigen::Matrix4d& worldOf(std::size_t node, int depth);
    Eigen::Matrix4d transformOf(const Json& node) const;
    template <int count>
    std::optional<Eigen::Matrix<double, count, 1>> numbersIn(const Json& node, const char* key) const;

    const FileBytes& m_file;
    const GltfDocument& m_gltf;
    StopCheck& m_stopCheck;
    std::size_t m_nodes = 0, m_instances = 0, m_joints = 0; ///< counts so far; the joints of a skin are counted once
    Eigen::Matrix4d m_root = Eigen::Matrix4d::Identity();
    std::vector<bool> m_isVisited;                     ///< whether each node was visited and is visible
    std::vector<std::optional<std::size_t>> m_parents; ///< parent of each node; filled when a joint first needs it
    std::map<std::size_t, Eigen::Matrix4d> m_worlds;   ///< transforms of joints and their ancestors, cached
    std::map<std::size_t, std::vector<Eigen::Matrix4d>> m_skins; ///< joint transforms of each skin, cached
};
} // namespace core::io
