#include "core/io/mesh/gltf_scene.h"

#include "core/io/mesh/gltf_instances.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace core::io
{
namespace
{
constexpr int maxDepth = 256;
constexpr std::size_t alwaysVisited = 1 << 16; ///< nodes, though the file has fewer
} // namespace

void GltfScene::forEachMesh(const Eigen::Matrix4d& root, const Visit& visit)
{
    for (const std::size_t node : rootNodes())
        visitNode(node, root, 0, visit);
    if (!m_gltf.arrayIn(m_gltf.document(), "nodes").empty() || hasScene())
        return;
    for (std::size_t i = 0; i < m_gltf.arrayIn(m_gltf.document(), "meshes").size(); ++i)
        visit(i, root);
}

bool GltfScene::hasScene() const
{
    return m_gltf.document().contains("scene") || !m_gltf.arrayIn(m_gltf.document(), "scenes").empty();
}

std::vector<std::size_t> GltfScene::rootNodes() const
{
    std::vector<std::size_t> roots;
    if (hasScene()) {
        const Json& scene = m_gltf.element("scenes", m_gltf.sizeIn(m_gltf.document(), "scene", 0));
        for (const Json& node : m_gltf.arrayIn(scene, "nodes"))
            roots.push_back(m_gltf.toIndex(node, "nodes"));
        return roots;
    }
    const std::size_t count = m_gltf.arrayIn(m_gltf.document(), "nodes").size();
    std::vector<bool> isChild(count, false);
    for (std::size_t i = 0; i < count; ++i)
        for (const Json& child : m_gltf.arrayIn(m_gltf.element("nodes", i), "children"))
            if (const std::size_t index = m_gltf.toIndex(child, "children"); index < count)
                isChild[index] = true;
    for (std::size_t i = 0; i < count; ++i)
        if (!isChild[i])
            roots.push_back(i);
    return roots;
}

void GltfScene::visitNode(std::size_t index, const Eigen::Matrix4d& above, int depth, const Visit& visit)
{
    m_stopCheck();
    if (depth > maxDepth)
        m_gltf.refuse(FileFault::TooDeep, "nodes");
    const std::size_t max = std::max(alwaysVisited, m_gltf.arrayIn(m_gltf.document(), "nodes").size());
    if (++m_nodes > max) // they are no tree
        throw tooMany("nodes", max, errorWithToken({}, m_file, {}));
    const Json& node = m_gltf.element("nodes", index);
    if (!isGltfVisible(m_gltf, node))
        return;
    const Eigen::Matrix4d transform = above * transformOf(node);
    visitInstances(node, transform, visit);
    for (const Json& child : m_gltf.arrayIn(node, "children"))
        visitNode(m_gltf.toIndex(child, "children"), transform, depth + 1, visit);
}

void GltfScene::visitInstances(const Json& node, const Eigen::Matrix4d& transform, const Visit& visit)
{
    const auto mesh = m_gltf.indexIn(node, "mesh");
    if (!mesh)
        return;
    for (const Eigen::Matrix4d& instance : gltfInstances(m_file, m_gltf, node)) {
        m_stopCheck();
        if (++m_instances > maxGltfInstances)
            throw tooMany("instances", maxGltfInstances, errorAtByte({}, m_file, m_file.bytes.data()));
        visit(*mesh, transform * instance);
    }
}

template <int count>
std::optional<Eigen::Matrix<double, count, 1>> GltfScene::numbersIn(const Json& node, const char* key) const
{
    const Json& values = m_gltf.arrayIn(node, key);
    if (values.empty())
        return std::nullopt;
    if (values.size() != count)
        m_gltf.refuse(FileFault::NotNumbers, key);
    Eigen::Matrix<double, count, 1> numbers;
    for (int i = 0; i < count; ++i) {
        if (!values[static_cast<std::size_t>(i)].is_number())
            m_gltf.refuse(FileFault::NotNumbers, key);
        numbers[i] = values[static_cast<std::size_t>(i)].get<double>();
    }
    return numbers;
}

Eigen::Matrix4d GltfScene::transformOf(const Json& node) const
{
    if (const auto matrix = numbersIn<16>(node, "matrix"))
        return Eigen::Map<const Eigen::Matrix4d>(matrix->data()); // columns first, as glTF has them
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (const auto by = numbersIn<3>(node, "translation"))
        transform.translate(*by);
    if (const auto turn = numbersIn<4>(node, "rotation"))
        transform.rotate(Eigen::Quaterniond((*turn)[3], (*turn)[0], (*turn)[1], (*turn)[2]).normalized());
    if (const auto scale = numbersIn<3>(node, "scale"))
        transform.scale(*scale);
    return transform.matrix();
}
} // namespace core::io
