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
/// The place of a mesh in a scene.
struct GltfPlace
{
    Eigen::Matrix4d transform; ///< from the mesh to the scene, unless joints say otherwise
    /// Holds the transforms from a mesh with a skin to where each joint takes it. They live as long as the GltfScene.
    std::span<const Eigen::Matrix4d> joints;
};

/// Walks the nodes of a glTF's scene that are visible, and their instances. A file without scenes has those that are no
/// other node's children; one without nodes, too, has its meshes as they are.
class GltfScene
{
public:
    /// `file`, `document`, `stopCheck`: not owned.
    GltfScene(const FileBytes& file, const GltfDocument& document, StopCheck& stopCheck)
        : m_file(file)
        , m_gltf(document)
        , m_stopCheck(stopCheck)
    {}

    /// Calls `visit` with each mesh of the scene, as often as it stands in it, and with its place in the space that
    /// `root` leads to. Joints stand as their nodes do. Throws FileError, and ReadingCancelled.
    using Visit = std::function<void(std::size_t mesh, const GltfPlace& place)>;
    void forEachMesh(const Eigen::Matrix4d& root, const Visit& visit);

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
    std::size_t m_nodes = 0, m_instances = 0, m_joints = 0; ///< numbers so far; joints once for each skin
    Eigen::Matrix4d m_root = Eigen::Matrix4d::Identity();
    std::vector<std::optional<std::size_t>> m_parents; ///< of the nodes, once a joint has asked for them
    std::map<std::size_t, Eigen::Matrix4d> m_worlds;   ///< of the joints and what they hang on, as far as asked for
    std::map<std::size_t, std::vector<Eigen::Matrix4d>> m_skins; ///< the joints of each, as far as asked for
};
} // namespace core::io
