#include "app/import/draco_decoder.h"

#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>

#include <stdexcept>

namespace app
{
namespace
{
/// Returns the glTF component type; 0 if glTF has no equivalent.
int componentTypeOf(draco::DataType type)
{
    switch (type) {
    case draco::DT_INT8:
        return 5120;
    case draco::DT_UINT8:
        return 5121;
    case draco::DT_INT16:
        return 5122;
    case draco::DT_UINT16:
        return 5123;
    case draco::DT_UINT32:
        return 5125;
    case draco::DT_FLOAT32:
        return 5126;
    default:
        return 0;
    }
}

/// Returns the attribute's value for each point; nothing if values are missing or glTF has no such type.
std::optional<core::DracoMesh::Attribute> attributeOf(const draco::PointAttribute& from, std::uint32_t points)
{
    core::DracoMesh::Attribute attribute{.id = from.unique_id(),
                                         .componentType = componentTypeOf(from.data_type()),
                                         .components = from.num_components(),
                                         .bytes = {}};
    const auto size = static_cast<std::size_t>(draco::DataTypeLength(from.data_type())) * from.num_components();
    if (attribute.componentType == 0 || size == 0 || from.byte_stride() < static_cast<std::int64_t>(size))
        return std::nullopt;
    attribute.bytes.reserve(points * size);
    for (std::uint32_t i = 0; i < points; ++i) {
        const draco::AttributeValueIndex value = from.mapped_index(draco::PointIndex(i));
        if (value.value() >= from.size())
            return std::nullopt;
        attribute.bytes.append(reinterpret_cast<const char*>(from.GetAddress(value)), size);
    }
    return attribute;
}

std::optional<core::DracoMesh> meshOf(const draco::Mesh& from, std::span<const std::uint32_t> ids)
{
    core::DracoMesh mesh{.vertices = from.num_points(), .corners = {}, .attributes = {}};
    mesh.corners.reserve(std::size_t(3) * from.num_faces());
    for (draco::FaceIndex face(0); face < from.num_faces(); ++face)
        for (const draco::PointIndex& corner : from.face(face))
            mesh.corners.push_back(corner.value());
    for (const std::uint32_t id : ids) {
        const draco::PointAttribute* const attribute = from.GetAttributeByUniqueId(id);
        if (!attribute)
            continue;
        auto values = attributeOf(*attribute, from.num_points());
        if (!values)
            return std::nullopt;
        mesh.attributes.push_back(*std::move(values));
    }
    return mesh;
}
} // namespace

std::optional<core::DracoMesh> decodedDraco(std::string_view stream, std::span<const std::uint32_t> ids)
{
    draco::DecoderBuffer buffer;
    buffer.Init(stream.data(), stream.size());
    try {
        const auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        return mesh.ok() ? meshOf(*mesh.value(), ids) : std::nullopt;
    } catch (const std::length_error&) { // the file declares more elements than a vector can have
        return std::nullopt;
    }
}
} // namespace app
