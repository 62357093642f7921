#pragma once

#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/gltf_draco.h"

namespace core::io
{
/// A glTF's primitive: its numbers, from the accessors or from the Draco stream that stands for them. Throws FileError
/// for whatever is not as it should be.
class GltfPrimitive
{
public:
    using Json = GltfDocument::Json;

    /// `file`, `gltf`, `draco`, `primitive`: not owned.
    GltfPrimitive(const FileBytes& file, const GltfDocument& gltf, GltfDraco& draco, const Json& primitive);

    /// Returns whether it is made of triangles: a list, a strip or a fan, and has positions.
    bool hasTriangles() const;
    /// Returns how its corners make triangles, as glTF numbers it.
    std::size_t mode() const;
    bool has(const std::string& attribute) const { return m_attributes.contains(attribute); }

    struct Numbers
    {
        LargeBuffer<float> values; ///< vertex after vertex; normalised ones from -1 or 0 to 1
        std::size_t components = 0;
    };
    /// Returns an attribute that it has, of `min` to `max` components.
    Numbers numbersOf(const std::string& attribute, int min, int max) const;
    /// Returns the vertices of its corners, each less than `vertices`. Without indices they follow each other.
    LargeBuffer<std::uint32_t> cornersOf(std::size_t vertices) const;

private:
    LargeBuffer<std::uint32_t> anyCornersOf(std::size_t vertices) const;

    const FileBytes& m_file;
    const GltfDocument& m_gltf;
    const GltfDraco& m_draco;
    const Json& m_primitive;
    const Json& m_attributes;
    const DracoMesh* m_decoded = nullptr; ///< null: its accessors have all
};
} // namespace core::io
