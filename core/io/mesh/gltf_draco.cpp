// Source: Khronos, KHR_draco_mesh_compression. The stream contains the primitive's indices and the attributes that the
// extension lists with their unique ids. The accessors declare the counts and types.
#include "core/io/mesh/gltf_draco.h"

#include <algorithm>

namespace core::io
{
namespace
{
using Json = GltfDocument::Json;

/// Returns the names of the attributes that are decoded; streams may contain others.
std::vector<std::string> readAttributes()
{
    std::vector<std::string> names{"POSITION", "COLOR_0", "_MASK"};
    for (std::size_t set = 0; set < maxJointSets; ++set)
        for (const char* const kind : {"JOINTS_", "WEIGHTS_"})
            names.push_back(kind + std::to_string(set));
    return names;
}

std::size_t sizeOf(const DracoMesh& mesh)
{
    std::size_t size = mesh.corners.size() * sizeof mesh.corners.front();
    for (const DracoMesh::Attribute& attribute : mesh.attributes)
        size += attribute.bytes.size();
    return size;
}
} // namespace

/// Returns whether the stream must be decoded: the file requires it, or no accessor has the positions.
bool GltfDraco::isNeeded(const Json& primitive) const
{
    if (m_gltf.isRequired(dracoExtension))
        return true;
    const auto attributes = primitive.find("attributes");
    const auto positions = attributes != primitive.end() && attributes->is_object()
                               ? m_gltf.indexIn(*attributes, "POSITION")
                               : std::nullopt;
    return positions && !m_gltf.element("accessors", *positions).contains("bufferView");
}

std::optional<std::uint32_t> GltfDraco::idOf(const Json& extension, const char* name) const
{
    const auto attributes = extension.find("attributes");
    if (attributes == extension.end() || !attributes->is_object())
        m_gltf.refuse(FileFault::NotAnObject, "attributes");
    const auto id = m_gltf.indexIn(*attributes, name);
    if (id && *id > UINT32_MAX)
        m_gltf.refuse(FileFault::NotAnIndex, name);
    return id ? std::optional(static_cast<std::uint32_t>(*id)) : std::nullopt;
}

const DracoMesh* GltfDraco::meshOf(const Json& primitive)
{
    const Json* const extension = gltfExtension(primitive, dracoExtension);
    if (!extension || !isNeeded(primitive))
        return nullptr;
    if (!extension->is_object())
        m_gltf.refuse(FileFault::NotAnObject, dracoExtension);
    if (!dracoDecoder())
        m_gltf.refuse(FileFault::NeedsExtension, dracoExtension, m_gltf.bytes());
    Key key;
    if (const auto view = m_gltf.indexIn(*extension, "bufferView"))
        key.first = *view;
    else
        m_gltf.refuse(FileFault::Missing, "bufferView");
    for (const std::string& name : readAttributes())
        if (const auto id = idOf(*extension, name.c_str()))
            key.second.push_back(*id);
    auto found = m_meshes.find(key);
    if (found == m_meshes.end())
        found = m_meshes.emplace(key, decoded(key)).first;
    return &found->second;
}

DracoMesh GltfDraco::decoded(const Key& key) const
{
    const std::string name = "bufferViews/" + std::to_string(key.first);
    std::optional<DracoMesh> mesh = dracoDecoder()(m_gltf.viewBytes(key.first), key.second);
    if (!mesh || mesh->corners.size() % 3 != 0)
        m_gltf.refuse(FileFault::CompressedWrong, name);
    m_gltf.countUnpacked(sizeOf(*mesh));
    return *std::move(mesh);
}

const DracoMesh::Attribute* GltfDraco::attributeOf(const Json& primitive, const DracoMesh& mesh, const char* name) const
{
    const auto id = idOf(*gltfExtension(primitive, dracoExtension), name);
    if (!id)
        return nullptr;
    const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                                    [id](const DracoMesh::Attribute& a) { return a.id == *id; });
    if (found == mesh.attributes.end())
        m_gltf.refuse(FileFault::Missing, name);
    return &*found;
}
} // namespace core::io
