#pragma once

#include "core/io/mesh/gltf_document.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace core::io
{
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

    /// Calls `visit` with each mesh of the scene, as often as it stands in it, and with the transform from it to the
    /// space that `root` leads to. Throws FileError, and ReadingCancelled.
    using Visit = std::function<void(std::size_t mesh, const Eigen::Matrix4d& transform)>;
    void forEachMesh(const Eigen::Matrix4d& root, const Visit& visit);

private:
    using Json = GltfDocument::Json;

    bool hasScene() const;
    std::vector<std::size_t> rootNodes() const;
    void visitNode(std::size_t index, const Eigen::Matrix4d& above, int depth, const Visit& visit);
    void visitInstances(const Json& node, const Eigen::Matrix4d& transform, const Visit& visit);
    Eigen::Matrix4d transformOf(const Json& node) const;
    template <int count>
    std::optional<Eigen::Matrix<double, count, 1>> numbersIn(const Json& node, const char* key) const;

    const FileBytes& m_file;
    const GltfDocument& m_gltf;
    StopCheck& m_stopCheck;
    std::size_t m_nodes = 0, m_instances = 0; ///< those so far
};
} // namespace core::io
