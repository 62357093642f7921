#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core
{
/// A triangle mesh decoded from a Draco stream.
struct DracoMesh
{
    /// One attribute, for example the positions, with its values for all vertices.
    struct Attribute
    {
        std::uint32_t id = 0;  ///< unique id of the attribute in the stream
        int componentType = 0; ///< glTF component type: 5120 to 5123, 5125 or 5126
        int components = 0;    ///< number of components of each vertex
        std::string bytes;     ///< values of all vertices in order without gaps, little-endian
    };

    std::size_t vertices = 0;
    std::vector<std::uint32_t> corners; ///< vertex indices, three for each triangle
    std::vector<Attribute> attributes;
};

/// Decodes a Draco stream and those of its attributes that have the given ids. Returns nothing if the stream is not a
/// complete mesh. The result may be inconsistent: the glTF reader checks it as it checks a file.
using DracoDecoder =
    std::function<std::optional<DracoMesh>(std::string_view stream, std::span<const std::uint32_t> ids)>;

/// Sets the decoder that this process uses to read Draco-compressed glTF. Without a decoder such files are left to the
/// external reader (external_reader.h). Precondition: no thread is reading a file.
void setDracoDecoder(DracoDecoder decoder);
/// Returns the decoder; empty if none was set.
const DracoDecoder& dracoDecoder();
} // namespace core
