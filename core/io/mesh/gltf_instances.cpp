// Sources: Khronos, EXT_mesh_gpu_instancing (attributes TRANSLATION, ROTATION and SCALE; others are for shaders only)
// and KHR_node_visibility.
#include "core/io/mesh/gltf_instances.h"

#include <Eigen/Geometry>

#include <optional>

namespace core::io
{
namespace
{
using Json = GltfDocument::Json;

constexpr std::string_view instancing = "EXT_mesh_gpu_instancing", visibility = "KHR_node_visibility";

/// Returns an extension; null if there is none. Throws if it is not an object.
const Json* extensionOf(const GltfDocument& gltf, const Json& node, std::string_view name)
{
    const Json* const extension = gltfExtension(node, name);
    if (extension && !extension->is_object())
        gltf.refuse(FileFault::NotAnObject, name);
    return extension;
}

/// Reads the attributes of a node's instances. All attributes must have the same count.
class InstanceReader
{
public:
    InstanceReader(const FileBytes& file, const GltfDocument& gltf, const Json& attributes)
        : m_file(file)
        , m_gltf(gltf)
        , m_attributes(attributes)
    {}

    /// Returns the attribute's numbers, instance by instance; empty if there is none.
    LargeBuffer<float> numbersOf(const char* name, int components)
    {
        const auto accessor = m_gltf.indexIn(m_attributes, name);
        if (!accessor)
            return LargeBuffer<float>(0);
        const GltfLayout layout = m_gltf.layoutOf(*accessor, components, components);
        if (layout.count > maxGltfInstances)
            throw tooMany("instances", maxGltfInstances, errorAtByte({}, m_file, m_file.bytes.data()));
        if (m_count.value_or(layout.count) != layout.count)
            m_gltf.refuse(FileFault::WrongAccessor, name);
        m_count = layout.count;
        return m_gltf.valuesOf(*accessor, layout, m_file.stop);
    }
    /// Returns the number of instances; nothing if no attribute has been read.
    std::optional<std::size_t> count() const { return m_count; }

private:
    const FileBytes& m_file;
    const GltfDocument& m_gltf;
    const Json& m_attributes;
    std::optional<std::size_t> m_count;
};
} // namespace

std::vector<Eigen::Matrix4d> gltfInstances(const FileBytes& file, const GltfDocument& gltf, const Json& node)
{
    const Json* const extension = extensionOf(gltf, node, instancing);
    if (!extension)
        return {Eigen::Matrix4d::Identity()};
    const auto attributes = extension->find("attributes");
    if (attributes == extension->end() || !attributes->is_object())
        gltf.refuse(FileFault::NotAnObject, "attributes");
    InstanceReader reader(file, gltf, *attributes);
    const LargeBuffer<float> places = reader.numbersOf("TRANSLATION", 3), turns = reader.numbersOf("ROTATION", 4),
                             scales = reader.numbersOf("SCALE", 3);
    if (!reader.count())
        return {Eigen::Matrix4d::Identity()};
    std::vector<Eigen::Matrix4d> instances;
    for (std::size_t i = 0; i < *reader.count(); ++i) {
        Eigen::Affine3d instance = Eigen::Affine3d::Identity();
        if (places.size() > 0)
            instance.translate(Eigen::Map<const Eigen::Vector3f>(&places[3 * i]).cast<double>());
        if (turns.size() > 0)
            instance.rotate(Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4f>(&turns[4 * i]).cast<double>())
                                .normalized()); // glTF order: x, y, z, w
        if (scales.size() > 0)
            instance.scale(Eigen::Map<const Eigen::Vector3f>(&scales[3 * i]).cast<double>());
        instances.push_back(instance.matrix());
    }
    return instances;
}

bool isGltfVisible(const GltfDocument& gltf, const Json& node)
{
    const Json* const extension = extensionOf(gltf, node, visibility);
    if (!extension)
        return true;
    const auto visible = extension->find("visible");
    return visible == extension->end() || *visible != Json(false);
}
} // namespace core::io
