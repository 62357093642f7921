#pragma once

#include "core/io/draco_stream.h"
#include "core/io/mesh/gltf_document.h"

#include <map>
#include <utility>
#include <vector>

namespace core::io
{
inline constexpr std::string_view dracoExtension = "KHR_draco_mesh_compression";

/// The most sets of joints, JOINTS_n with WEIGHTS_n, that bind a primitive. Nothing else bounds them: all may name the
/// same bytes.
inline constexpr std::size_t maxJointSets = 8;

/// Decodes the primitives that KHR_draco_mesh_compression packs, each stream once.
class GltfDraco
{
public:
    /// `gltf`: not owned.
    explicit GltfDraco(const GltfDocument& gltf) : m_gltf(gltf) {}

    /// Returns the mesh that stands for the primitive; null if its accessors have all that it needs. Throws FileError:
    /// Malformed for a stream that is broken or that the JSON describes otherwise; Malformed with NeedsExtension where
    /// there is no decoder; UnpacksTooLarge.
    const DracoMesh* meshOf(const GltfDocument::Json& primitive);
    /// Returns the primitive's attribute in its mesh; null if the stream does not hold it.
    const DracoMesh::Attribute* attributeOf(const GltfDocument::Json& primitive, const DracoMesh& mesh,
                                            const char* name) const;

private:
    using Json = GltfDocument::Json;
    using Key = std::pair<std::size_t, std::vector<std::uint32_t>>; ///< buffer view, ids

    bool isNeeded(const Json& primitive) const;
    std::optional<std::uint32_t> idOf(const Json& extension, const char* name) const;
    DracoMesh decoded(const Key& key) const;

    const GltfDocument& m_gltf;
    std::map<Key, DracoMesh> m_meshes;
};
} // namespace core::io
