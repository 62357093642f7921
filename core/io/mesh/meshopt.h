#pragma once

#include "core/io/mesh/format.h"

#include <string>

namespace core::io
{
/// A buffer view's data as EXT_meshopt_compression and KHR_meshopt_compression pack them.
struct MeshoptView
{
    enum class Mode { Attributes, Triangles, Indices };
    enum class Filter { None, Octahedral, Quaternion, Exponential, Color };

    std::string_view data; ///< packed
    Mode mode = Mode::Attributes;
    Filter filter = Filter::None;
    std::size_t count = 0;  ///< elements
    std::size_t stride = 0; ///< bytes of an element: of attributes a multiple of 4 up to 256, of indices 2 or 4
    std::string name;       ///< of the view, for errors
};

/// The most bytes that one packed byte can stand for.
inline constexpr std::size_t maxMeshoptRatio = 1024;

/// Returns the view's elements, unpacked and filtered. Precondition: count, stride and filter are as the extensions
/// allow them. Throws FileError::Malformed: CompressedCut if the data end too early, else CompressedWrong. Memory:
/// twice the result.
std::string meshoptUnpacked(const FileBytes& file, const MeshoptView& view);

/// Bytes that are read one after the other. Throws as meshoptUnpacked().
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
    /// Cuts `size` bytes off the end.
    std::string_view takeTail(std::size_t size);
    /// Throws if any is left.
    void requireEnd() const;
    [[noreturn]] void refuse(FileFault fault) const;

private:
    const FileBytes& m_file;
    const MeshoptView& m_view;
    std::string_view m_rest;
};

/// Steps of meshoptUnpacked(), which chooses among them.
std::string meshoptAttributes(const FileBytes& file, const MeshoptView& view);
std::string meshoptTriangles(const FileBytes& file, const MeshoptView& view);
std::string meshoptIndices(const FileBytes& file, const MeshoptView& view);
void applyMeshoptFilter(const MeshoptView& view, std::string& elements);
} // namespace core::io
