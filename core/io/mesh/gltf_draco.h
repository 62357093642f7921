#pragma once

#include "core/io/draco_stream.h"
#include "core/io/mesh/gltf_document.h"

#include <map>
#include <utility>
#include <vector>

namespace core::io
{
inline constexpr std::string_view dracoExtension = "KHR_draco_mesh_compression";

/// Largest number of joint sets (JOINTS_n with WEIGHTS_n) of a primitive. The file's size does not bound them, because
/// all sets may use the same bytes.
inline constexpr std::size_t maxJointSets = 8;

/// Decodes primitives that KHR_draco_mesh_compression compresses. Each stream is decoded once.
class GltfDraco
{
public:
    /// `gltf`: not owned.
    explicit GltfDraco(const GltfDocument& gltf) : m_gltf(gltf) {}

    /// Returns the decoded mesh of the primitive; null if its accessors contain all data. Throws FileError: Malformed
    /// if the stream is damaged or contradicts the JSON, Malformed with NeedsExtension if there is no decoder, or
    /// UnpacksTooLarge.
    const DracoMesh* meshOf(const GltfDocument::Json& primitive);
    /// Returns the primitive's attribute in its decoded mesh; null if the extension does not list it. Throws FileError
    /// if it is listed and the mesh lacks it.
    const DracoMesh::Attribute* attributeOf(const GltfDocument::Json& primitive, const DracoMesh& mesh,
                                            const char* name) const;

private:
    using Json = GltfDocument::Json;
    using Key = std::pair<std::size_t, std::vector<std::uint32_t>>; ///< buffer view, attribute ids

    bool isNeeded(const Json& primitive) const;
    std::optional<std::uint32_t> idOf(const Json& extension, const char* name) const;
    DracoMesh decoded(const Key& key) const;

    const GltfDocument& m_gltf;
    std::map<Key, DracoMesh> m_meshes;
};
} // namespace core::io
