#include "core/io/mesh/gltf_primitive.h"

#include <algorithm>
#include <numeric>

namespace core::io
{
namespace
{
const GltfDocument::Json& attributesOf(const GltfDocument& gltf, const GltfDocument::Json& primitive)
{
    if (!primitive.is_object())
        gltf.refuse(FileFault::NotAnObject, "primitives");
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object())
        gltf.refuse(FileFault::NotAnObject, "attributes");
    return *attributes;
}
} // namespace

GltfPrimitive::GltfPrimitive(const FileBytes& file, const GltfDocument& gltf, GltfDraco& draco, const Json& primitive)
    : m_file(file)
    , m_gltf(gltf)
    , m_draco(draco)
    , m_primitive(primitive)
    , m_attributes(attributesOf(gltf, primitive))
{
    if (hasTriangles())
        m_decoded = draco.meshOf(primitive);
}

bool GltfPrimitive::hasTriangles() const
{
    const std::size_t mode = m_gltf.sizeIn(m_primitive, "mode", GltfTriangles);
    const bool isOfTriangles = mode == GltfTriangles || mode == GltfTriangleStrip || mode == GltfTriangleFan;
    return isOfTriangles && has("POSITION");
}

std::size_t GltfPrimitive::mode() const
{
    return m_decoded ? std::size_t(GltfTriangles) : m_gltf.sizeIn(m_primitive, "mode", GltfTriangles);
}

GltfPrimitive::Numbers GltfPrimitive::numbersOf(const std::string& attribute, int min, int max) const
{
    const std::size_t accessor = m_gltf.indexIn(m_attributes, attribute.c_str()).value_or(0);
    const DracoMesh::Attribute* const decoded =
        m_decoded ? m_draco.attributeOf(m_primitive, *m_decoded, attribute.c_str()) : nullptr;
    if (const Json& from = m_gltf.element("accessors", accessor);
        m_decoded && !decoded && !from.contains("bufferView") && !from.contains("sparse"))
        m_gltf.refuse(FileFault::Missing, attribute); // neither the stream nor the accessor has the attribute
    GltfLayout own;
    if (decoded && m_decoded->vertices != 0)
        own = {.first = decoded->bytes.data(),
               .count = m_decoded->vertices,
               .stride = decoded->bytes.size() / m_decoded->vertices,
               .componentType = decoded->componentType,
               .components = decoded->components};
    const GltfLayout layout = m_gltf.layoutOf(accessor, min, max, decoded ? &own : nullptr);
    return {m_gltf.valuesOf(accessor, layout, m_file.stop), static_cast<std::size_t>(layout.components)};
}

LargeBuffer<std::uint32_t> GltfPrimitive::anyCornersOf(std::size_t vertices) const
{
    const auto indices = m_gltf.indexIn(m_primitive, "indices");
    if (m_decoded) {
        LargeBuffer<std::uint32_t> corners(m_decoded->corners.size());
        std::copy(m_decoded->corners.begin(), m_decoded->corners.end(), corners.data());
        const bool isList = m_gltf.sizeIn(m_primitive, "mode", GltfTriangles) == GltfTriangles;
        if (indices && isList && m_gltf.sizeIn(m_gltf.element("accessors", *indices), "count", 0) != corners.size())
            m_gltf.refuse(FileFault::WrongAccessor, "accessors/" + std::to_string(*indices));
        return corners;
    }
    if (indices)
        return m_gltf.wholesOf(*indices, m_file.stop);
    LargeBuffer<std::uint32_t> corners(vertices);
    std::iota(corners.data(), corners.data() + vertices, 0U);
    return corners;
}

LargeBuffer<std::uint32_t> GltfPrimitive::cornersOf(std::size_t vertices) const
{
    LargeBuffer<std::uint32_t> corners = anyCornersOf(vertices);
    for (const std::uint32_t corner : corners.part(0, corners.size()))
        if (corner >= vertices)
            throw withCounts(errorWithToken(FileErrorKind::IndexOutOfRange, m_file, std::to_string(corner)), vertices);
    return corners;
}
} // namespace core::io
