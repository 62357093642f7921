#pragma once

#include "core/io/mesh/format.h"

#include <string>

namespace core::io
{
/// A buffer view compressed with EXT_meshopt_compression or KHR_meshopt_compression.
struct MeshoptView
{
    enum class Mode { Attributes, Triangles, Indices };
    enum class Filter { None, Octahedral, Quaternion, Exponential, Color };

    std::string_view data; ///< compressed
    Mode mode = Mode::Attributes;
    Filter filter = Filter::None;
    std::size_t count = 0;  ///< number of elements
    std::size_t stride = 0; ///< bytes of an element: for attributes a multiple of 4 up to 256, for indices 2 or 4
    std::string name;       ///< name of the view, for errors
};

/// Largest number of bytes that one compressed byte can produce.
inline constexpr std::size_t maxMeshoptRatio = 1024;

/// Returns the signed number, in two's complement, that zigzag encoding wrote as `value`.
constexpr std::uint32_t withoutZigzag(std::uint32_t value)
{
    return (value & 1) != 0 ? ~(value >> 1) : value >> 1;
}

/// Returns the view's elements, unpacked and filtered. Precondition: count, stride and filter are allowed by the
/// extensions. Throws FileError::Malformed: CompressedCut if the data end too early, else CompressedWrong. Memory:
/// twice the result.
std::string meshoptUnpacked(const FileBytes& file, const MeshoptView& view);

/// Reads bytes one after the other. Throws as meshoptUnpacked().
class MeshoptBytes
{
public:
    MeshoptBytes(const FileBytes& file, const MeshoptView& view, std::string_view bytes)
        : m_file(file)
        , m_view(view)
        , m_rest(bytes)
    {}

    std::string_view take(std::size_t size);
    std::uint8_t byte() { return static_cast<std::uint8_t>(take(1).front()); }
    std::uint32_t varint();
    /// Removes `size` bytes from the end and returns them.
    std::string_view takeTail(std::size_t size);
    /// Throws CompressedWrong if bytes are left.
    void requireEnd() const;
    [[noreturn]] void refuse(FileFault fault) const;

private:
    const FileBytes& m_file;
    const MeshoptView& m_view;
    std::string_view m_rest;
};

/// Steps of meshoptUnpacked(): the first three functions unpack one mode each, the last applies a filter.
std::string meshoptAttributes(const FileBytes& file, const MeshoptView& view);
std::string meshoptTriangles(const FileBytes& file, const MeshoptView& view);
std::string meshoptIndices(const FileBytes& file, const MeshoptView& view);
void applyMeshoptFilter(const MeshoptView& view, std::string& elements);
} // namespace core::io
