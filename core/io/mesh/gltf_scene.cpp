#include "core/io/mesh/gltf_scene.h"

#include "core/io/mesh/gltf_instances.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace core::io
{
namespace
{
constexpr std::size_t maxJoints = 1 << 18; ///< largest number of joints of all skins
constexpr int maxDepth = 256;
/// Number of node visits that is always allowed, even if the file has fewer nodes.
constexpr std::size_t alwaysVisited = 1 << 16;

/// Returns the name of a node; empty if it has none.
std::string_view nameOf(const GltfDocument::Json& node)
{
    const auto name = node.find("name");
    return name != node.end() && name->is_string() ? std::string_view(name->get_ref<const std::string&>())
                                                   : std::string_view();
}
} // namespace

void GltfScene::forEachMesh(const Eigen::Matrix4d& root, const Visit& visit)
{
    m_root = root;
    m_isVisited.resize(m_gltf.arrayIn(m_gltf.document(), "nodes").size(), false);
    for (const std::size_t node : rootNodes())
        visitNode(node, root, 0, visit);
    if (!m_gltf.arrayIn(m_gltf.document(), "nodes").empty() || hasScene())
        return;
    for (std::size_t i = 0; i < m_gltf.arrayIn(m_gltf.document(), "meshes").size(); ++i)
        visit(i, {root, {}});
}

std::size_t GltfScene::hiddenObjects() const
{
    const Json &nodes = m_gltf.arrayIn(m_gltf.document(), "nodes"),
               &meshes = m_gltf.arrayIn(m_gltf.document(), "meshes");
    std::vector<bool> isLevel(nodes.size(), false), isUsed(meshes.size(), nodes.empty());
    const auto mark = [](std::vector<bool>& marks, const Json& index) {
        if (index.is_number_unsigned() && index.get<std::uint64_t>() < marks.size())
            marks[index.get<std::size_t>()] = true;
    };
    for (const Json& node : nodes) {
        if (!node.is_object())
            continue;
        mark(isUsed, node.value("mesh", Json()));
        const Json* const levels = gltfExtension(node, "MSFT_lod");
        for (const Json& level : levels && levels->is_object() ? levels->value("ids", Json::array()) : Json::array())
            mark(isLevel, level);
    }
    std::size_t hidden = static_cast<std::size_t>(std::ranges::count(isUsed, false));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        hidden += nodes[i].is_object() && nodes[i].contains("mesh") && !m_isVisited[i] && !isLevel[i] ? 1 : 0;
    return hidden;
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
    const std::vector<std::optional<std::size_t>> above = parents();
    for (std::size_t i = 0; i < above.size(); ++i)
        if (!above[i])
            roots.push_back(i);
    return roots;
}

std::vector<std::optional<std::size_t>> GltfScene::parents() const
{
    std::vector<std::optional<std::size_t>> parents(m_gltf.arrayIn(m_gltf.document(), "nodes").size());
    for (std::size_t i = 0; i < parents.size(); ++i)
        for (const Json& child : m_gltf.arrayIn(m_gltf.element("nodes", i), "children"))
            if (const std::size_t index = m_gltf.toIndex(child, "children"); index < parents.size())
                parents[index] = i;
    return parents;
}

void GltfScene::visitNode(std::size_t index, const Eigen::Matrix4d& above, int depth, const Visit& visit)
{
    m_stopCheck();
    if (depth > maxDepth)
        m_gltf.refuse(FileFault::TooDeep, "nodes");
    const std::size_t max = std::max(alwaysVisited, m_gltf.arrayIn(m_gltf.document(), "nodes").size());
    if (++m_nodes > max) // the nodes do not form a tree
        throw tooMany("nodes", max, errorWithToken({}, m_file, {}));
    const Json& node = m_gltf.element("nodes", index);
    if (!isGltfVisible(m_gltf, node))
        return;
    m_isVisited[index] = true;
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
    const auto skin = m_gltf.indexIn(node, "skin");
    GltfPlace place{transform, skin ? jointsOf(*skin) : std::span<const Eigen::Matrix4d>(), nameOf(node)};
    for (const Eigen::Matrix4d& instance : gltfInstances(m_file, m_gltf, node)) {
        m_stopCheck();
        if (++m_instances > maxGltfInstances)
            throw tooMany("instances", maxGltfInstances, errorAtByte({}, m_file, m_file.bytes.data()));
        place.transform = transform * instance;
        visit(*mesh, place);
    }
}

std::span<const Eigen::Matrix4d> GltfScene::jointsOf(std::size_t skin)
{
    const auto [found, isNew] = m_skins.try_emplace(skin);
    std::vector<Eigen::Matrix4d>& transforms = found->second;
    if (!isNew)
        return transforms;
    const Json& from = m_gltf.element("skins", skin);
    const Json& joints = m_gltf.arrayIn(from, "joints");
    if ((m_joints += joints.size()) > maxJoints)
        throw tooMany("joints", maxJoints, errorWithToken({}, m_file, {}));
    for (const Json& joint : joints)
        transforms.push_back(worldOf(m_gltf.toIndex(joint, "joints"), 0));
    const auto accessor = m_gltf.indexIn(from, "inverseBindMatrices");
    if (!accessor)
        return transforms;
    constexpr int each = 16;
    const GltfLayout layout = m_gltf.layoutOf(*accessor, each, each);
    if (layout.count < joints.size())
        m_gltf.refuse(FileFault::WrongAccessor, "inverseBindMatrices");
    const LargeBuffer<float> inverses = m_gltf.valuesOf(*accessor, layout, m_file.stop);
    for (std::size_t i = 0; i < transforms.size(); ++i)
        transforms[i] *= Eigen::Map<const Eigen::Matrix4f>(&inverses[each * i]).cast<double>();
    return transforms;
}

/// Returns the transform from a node to the space of `root` in forEachMesh().
const Eigen::Matrix4d& GltfScene::worldOf(std::size_t node, int depth)
{
    if (depth > maxDepth)
        m_gltf.refuse(FileFault::TooDeep, "nodes");
    if (const auto found = m_worlds.find(node); found != m_worlds.end())
        return found->second;
    const Json& from = m_gltf.element("nodes", node);
    if (m_parents.empty())
        m_parents = parents();
    const auto parent = m_parents[node];
    const Eigen::Matrix4d above = parent ? worldOf(*parent, depth + 1) : m_root;
    return m_worlds.emplace(node, above * transformOf(from)).first->second;
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
        return Eigen::Map<const Eigen::Matrix4d>(matrix->data()); // column-major, as in glTF
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
