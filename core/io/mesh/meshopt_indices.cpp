// Source: KHR_meshopt_compression, appendix A, modes 1 and 2, which are also those of EXT_meshopt_compression.
#include "core/io/mesh/meshopt.h"

#include <array>
#include <optional>

namespace core::io
{
namespace
{
/// Collects indices of 2 or 4 bytes.
class IndexWriter
{
public:
    IndexWriter(const MeshoptView& view, const MeshoptBytes& bytes) : m_stride(view.stride), m_bytes(bytes)
    {
        m_indices.reserve(view.count * view.stride);
    }

    void add(std::uint32_t index)
    {
        if (m_stride == 2 && index > 0xffff)
            m_bytes.refuse(FileFault::CompressedWrong);
        for (std::size_t k = 0; k < m_stride; ++k)
            m_indices += static_cast<char>(index >> 8 * k);
    }
    std::string take() { return std::move(m_indices); }

private:
    std::size_t m_stride;
    const MeshoptBytes& m_bytes;
    std::string m_indices;
};

/// The last sixteen entries that were added.
template <class Entry> class Fifo
{
public:
    void add(const Entry& entry) { m_entries[m_next++ % m_entries.size()] = entry; }
    /// Returns the entry of this age, 0 for the latest; nothing if fewer were added.
    std::optional<Entry> at(std::size_t age) const
    {
        return age < m_next ? std::optional(m_entries[(m_next - 1 - age) % m_entries.size()]) : std::nullopt;
    }

private:
    std::array<Entry, 16> m_entries{};
    std::size_t m_next = 0;
};

class TriangleReader
{
public:
    TriangleReader(const FileBytes& file, const MeshoptView& view)
        : m_stopCheck(file.stop)
        , m_count(view.count / 3)
        , m_bytes(file, view, view.data)
        , m_writer(view, m_bytes)
    {}

    std::string read()
    {
        constexpr std::uint8_t header = 0xe1;
        if (m_bytes.byte() != header)
            m_bytes.refuse(FileFault::CompressedWrong);
        const std::string_view codes = m_bytes.take(m_count), pairs = m_bytes.takeTail(16);
        if (pairs[14] != 0 || pairs[15] != 0)
            m_bytes.refuse(FileFault::CompressedWrong);
        for (const char pair : pairs)
            if ((pair & 0xf) == 0xf || (pair & 0xf0) == 0xf0)
                m_bytes.refuse(FileFault::CompressedWrong);
        for (const char c : codes) {
            m_stopCheck();
            const auto code = static_cast<std::uint8_t>(c);
            if (code < 0xf0)
                readAtEdge(code >> 4, code & 15);
            else
                readAlone(code, code < 0xfe ? static_cast<std::uint8_t>(pairs[code & 15]) : m_bytes.byte());
        }
        m_bytes.requireEnd();
        return m_writer.take();
    }

private:
    template <class Entry> Entry required(const std::optional<Entry>& entry) const
    {
        if (!entry)
            m_bytes.refuse(FileFault::CompressedWrong);
        return *entry;
    }

    std::uint32_t explicitIndex() { return m_last += withoutZigzag(m_bytes.varint()); }

    /// Reads a triangle that shares an earlier edge. `what`: a code for where its third corner comes from.
    void readAtEdge(std::size_t edge, unsigned what)
    {
        const auto [a, b] = required(m_edges.at(edge));
        const std::uint32_t c = what == 0     ? m_next++
                                : what < 0xd  ? required(m_vertices.at(what))
                                : what == 0xd ? --m_last
                                : what == 0xe ? ++m_last
                                              : explicitIndex();
        m_edges.add({c, b});
        m_edges.add({a, c});
        if (what == 0 || what >= 0xd)
            m_vertices.add(c);
        add(a, b, c);
    }

    /// Reads a triangle that shares no edge. `pair`: two 4-bit codes for where its second and third
    /// corner come from.
    void readAlone(unsigned code, unsigned pair)
    {
        if (code >= 0xfe && pair == 0)
            m_next = 0;
        const auto corner = [this](unsigned what) {
            return what == 0 ? m_next++ : what == 0xf ? explicitIndex() : required(m_vertices.at(what - 1));
        };
        const unsigned second = pair >> 4, third = pair & 15;
        const std::uint32_t a = code == 0xff ? explicitIndex() : m_next++;
        const std::uint32_t b = corner(second);
        const std::uint32_t c = corner(third);
        m_edges.add({b, a});
        m_edges.add({c, b});
        m_edges.add({a, c});
        m_vertices.add(a);
        if (second == 0 || second == 0xf)
            m_vertices.add(b);
        if (third == 0 || third == 0xf)
            m_vertices.add(c);
        add(a, b, c);
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        m_writer.add(a);
        m_writer.add(b);
        m_writer.add(c);
    }

    StopCheck m_stopCheck;
    std::size_t m_count;
    MeshoptBytes m_bytes;
    IndexWriter m_writer;
    /// The next unused index, and the latest index that is explicit in the data.
    std::uint32_t m_next = 0, m_last = 0;
    Fifo<std::array<std::uint32_t, 2>> m_edges;
    Fifo<std::uint32_t> m_vertices;
};
} // namespace

std::string meshoptTriangles(const FileBytes& file, const MeshoptView& view)
{
    return TriangleReader(file, view).read();
}

std::string meshoptIndices(const FileBytes& file, const MeshoptView& view)
{
    constexpr std::uint8_t header = 0xd1;
    MeshoptBytes bytes(file, view, view.data);
    if (bytes.byte() != header)
        bytes.refuse(FileFault::CompressedWrong);
    bytes.takeTail(4);
    IndexWriter writer(view, bytes);
    StopCheck stopCheck(file.stop);
    std::array<std::uint32_t, 2> last{};
    for (std::size_t i = 0; i < view.count; ++i) {
        stopCheck();
        const std::uint32_t code = bytes.varint();
        writer.add(last[code & 1] += withoutZigzag(code >> 1));
    }
    bytes.requireEnd();
    return writer.take();
}
} // namespace core::io
