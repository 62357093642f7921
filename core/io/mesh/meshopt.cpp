// Sources: Khronos, EXT_meshopt_compression and the draft of KHR_meshopt_compression.
#include "core/io/mesh/meshopt.h"

namespace core::io
{
std::string meshoptUnpacked(const FileBytes& file, const MeshoptView& view)
{
    if (view.count * view.stride / maxMeshoptRatio > view.data.size())
        MeshoptBytes(file, view, view.data).refuse(FileFault::CompressedCut);
    switch (view.mode) {
    case MeshoptView::Mode::Triangles:
        return meshoptTriangles(file, view);
    case MeshoptView::Mode::Indices:
        return meshoptIndices(file, view);
    case MeshoptView::Mode::Attributes:
        break;
    }
    std::string elements = meshoptAttributes(file, view);
    applyMeshoptFilter(view, elements);
    return elements;
}

std::string_view MeshoptBytes::take(std::size_t size)
{
    if (size > m_rest.size())
        refuse(FileFault::CompressedCut);
    const std::string_view taken = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return taken;
}

/// Reads an integer in base 128, lowest digit first. All bytes except the last have their highest bit set.
std::uint32_t MeshoptBytes::varint()
{
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift <= 28; shift += 7) {
        const std::uint8_t digit = byte();
        value |= std::uint32_t(digit & 0x7f) << shift;
        if (digit < 0x80)
            return value;
    }
    refuse(FileFault::CompressedWrong);
}

std::string_view MeshoptBytes::takeTail(std::size_t size)
{
    if (size > m_rest.size())
        refuse(FileFault::CompressedCut);
    const std::string_view taken = m_rest.substr(m_rest.size() - size);
    m_rest.remove_suffix(size);
    return taken;
}

void MeshoptBytes::requireEnd() const
{
    if (!m_rest.empty())
        refuse(FileFault::CompressedWrong);
}

void MeshoptBytes::refuse(FileFault fault) const
{
    throw malformed(fault, errorWithToken({}, m_file, m_view.name));
}
} // namespace core::io
