#pragma once

#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/gltf_draco.h"

namespace core::io
{
/// A primitive of a glTF. Its numbers are read from the accessors or from the Draco stream that replaces them. Throws
/// FileError if the primitive is not valid.
class GltfPrimitive
{
public:
    using Json = GltfDocument::Json;

    /// `file`, `gltf`, `draco`, `primitive`: not owned.
    GltfPrimitive(const FileBytes& file, const GltfDocument& gltf, GltfDraco& draco, const Json& primitive);

    /// Returns whether the primitive has positions and consists of triangles: a list, a strip or a fan.
    bool hasTriangles() const;
    /// Returns the glTF mode that says how the corners form triangles.
    std::size_t mode() const;
    bool has(const std::string& attribute) const { return m_attributes.contains(attribute); }

    struct Numbers
    {
        LargeBuffer<float> values; ///< vertex by vertex; normalised numbers are from -1 or 0 to 1
        std::size_t components = 0;
    };
    /// Returns the numbers of an attribute with `min` to `max` components. Precondition: has(attribute).
    Numbers numbersOf(const std::string& attribute, int min, int max) const;
    /// Returns the vertex index of each corner, all less than `vertices`. Without indices the corners are the vertices
    /// in order.
    LargeBuffer<std::uint32_t> cornersOf(std::size_t vertices) const;

private:
    LargeBuffer<std::uint32_t> anyCornersOf(std::size_t vertices) const;

    const FileBytes& m_file;
    const GltfDocument& m_gltf;
    const GltfDraco& m_draco;
    const Json& m_primitive;
    const Json& m_attributes;
    const DracoMesh* m_decoded = nullptr; ///< null: the accessors contain all data
};
} // namespace core::io
