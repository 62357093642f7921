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
/// A triangle mesh as a Draco stream holds it.
struct DracoMesh
{
    /// The numbers of all vertices.
    struct Attribute
    {
        std::uint32_t id = 0;  ///< its unique id in the stream
        int componentType = 0; ///< as glTF numbers it: 5120 to 5123, 5125, 5126
        int components = 0;    ///< of a vertex
        std::string bytes;     ///< vertex after vertex without gaps, little-endian
    };

    std::size_t vertices = 0;
    std::vector<std::uint32_t> corners; ///< three for each triangle
    std::vector<Attribute> attributes;
};

/// Decodes a Draco stream, and of its attributes those with the given ids. Returns nothing if the stream is not a whole
/// mesh. The result need not be sound: glTF's reader checks it as it would check a file.
using DracoDecoder =
    std::function<std::optional<DracoMesh>(std::string_view stream, std::span<const std::uint32_t> ids)>;

/// Sets the decoder with which this process reads glTF that Draco packed; without one such files are for the external
/// reader (external_reader.h). Precondition: no thread reads.
void setDracoDecoder(DracoDecoder decoder);
/// Returns the decoder; empty if there is none.
const DracoDecoder& dracoDecoder();
} // namespace core
