// Source: KHR_meshopt_compression, appendix A, mode 0, versions 0 and 1. Version 0 is also that of
// EXT_meshopt_compression.
#include "core/io/mesh/meshopt.h"

#include <algorithm>
#include <array>

namespace core::io
{
namespace
{
constexpr std::size_t groupSize = 16, maxBlock = 256, maxStride = 256;

std::uint8_t& byteAt(char* bytes, std::size_t at)
{
    return reinterpret_cast<std::uint8_t*>(bytes)[at];
}

/// Unpacks the elements block by block. A block contains the deltas of the first byte of all its elements, then those
/// of the second byte, and so on.
class AttributeReader
{
public:
    AttributeReader(const FileBytes& file, const MeshoptView& view)
        : m_stopCheck(file.stop)
        , m_count(view.count)
        , m_stride(view.stride)
        , m_bytes(file, view, view.data)
    {
        constexpr std::uint8_t firstVersion = 0xa0, secondVersion = 0xa1;
        const std::uint8_t header = m_bytes.byte();
        if (header != firstVersion && header != secondVersion)
            m_bytes.refuse(FileFault::CompressedWrong);
        m_isFirstVersion = header == firstVersion;
        const std::size_t channels = m_isFirstVersion ? 0 : m_stride / 4;
        const std::string_view tail =
            m_bytes.takeTail(std::max(m_stride + channels, std::size_t(m_isFirstVersion ? 32 : 24)));
        std::copy_n(tail.end() - m_stride - channels, m_stride, m_last.begin());
        std::copy_n(tail.end() - channels, channels, m_channels.begin());
        for (const std::uint8_t channel : m_channels)
            if ((channel & 15) > 2 || ((channel & 15) < 2 && channel > 15))
                m_bytes.refuse(FileFault::CompressedWrong);
    }

    std::string read()
    {
        std::string elements(m_count * m_stride, '\0');
        const std::size_t largest = std::min(8192 / m_stride / groupSize * groupSize, maxBlock);
        for (std::size_t done = 0; done < m_count;) {
            const std::size_t size = std::min(m_count - done, largest);
            m_stopCheck(size * m_stride);
            readDeltas(size);
            for (std::size_t channel = 0; channel < m_stride / 4; ++channel)
                addDeltas(channel, size, elements.data() + done * m_stride + 4 * channel);
            done += size;
        }
        m_bytes.requireEnd();
        return elements;
    }

private:
    void readDeltas(std::size_t size)
    {
        const std::string_view controls = m_isFirstVersion ? std::string_view() : m_bytes.take(m_stride / 4);
        for (std::size_t k = 0; k < m_stride; ++k) {
            auto& deltas = m_deltas[k];
            const int control = m_isFirstVersion ? -1 : static_cast<std::uint8_t>(controls[k / 4]) >> 2 * (k % 4) & 3;
            if (control == 2)
                deltas.fill(0);
            else if (control == 3)
                std::ranges::copy(m_bytes.take(size), deltas.begin());
            else
                readGroups(control < 0    ? std::array{0, 2, 4, 8}
                           : control == 0 ? std::array{0, 1, 2, 4}
                                          : std::array{1, 2, 4, 8},
                           (size + groupSize - 1) / groupSize, deltas.data());
        }
    }

    void readGroups(const std::array<int, 4>& widths, std::size_t groups, std::uint8_t* into)
    {
        const std::string_view header = m_bytes.take((groups + 3) / 4);
        for (std::size_t i = 0; i < groups; ++i)
            readGroup(widths[static_cast<std::uint8_t>(header[i / 4]) >> 2 * (i % 4) & 3], into + i * groupSize);
    }

    /// Unpacks the deltas of 16 elements. A delta that does not fit into `width` bits follows as a byte.
    void readGroup(int width, std::uint8_t* into)
    {
        const std::string_view packed = m_bytes.take(groupSize * static_cast<std::size_t>(width) / 8);
        const unsigned perByte = width == 0 ? 1 : 8U / static_cast<unsigned>(width), all = (1U << width) - 1;
        for (unsigned i = 0; i < groupSize; ++i) {
            if (width == 0 || width == 8) {
                into[i] = width == 0 ? 0 : static_cast<std::uint8_t>(packed[i]);
                continue;
            }
            const unsigned place = width == 1 ? i % perByte : perByte - 1 - i % perByte;
            const unsigned bits =
                static_cast<std::uint8_t>(packed[i / perByte]) >> place * static_cast<unsigned>(width) & all;
            into[i] = bits == all ? m_bytes.byte() : static_cast<std::uint8_t>(bits);
        }
    }

    /// Applies the deltas of four bytes to `size` elements; `into` is the first. Bytes and 16-bit integers are added,
    /// 32-bit integers are combined by exclusive or.
    void addDeltas(std::size_t channel, std::size_t size, char* into)
    {
        const std::uint8_t how = m_channels[channel];
        const auto delta = [&](std::size_t k, std::size_t i) { return std::uint32_t(m_deltas[4 * channel + k][i]); };
        std::uint8_t* const last = &m_last[4 * channel];
        for (std::size_t i = 0; i < size; ++i, into += m_stride) {
            if (how == 0) {
                for (std::size_t k = 0; k < 4; ++k)
                    last[k] = static_cast<std::uint8_t>(last[k] + withoutZigzag(delta(k, i)));
            } else if (how == 1) {
                for (std::size_t k = 0; k < 4; k += 2) {
                    const std::uint32_t sum =
                        (last[k] | std::uint32_t(last[k + 1]) << 8) + withoutZigzag(delta(k, i) | delta(k + 1, i) << 8);
                    last[k] = static_cast<std::uint8_t>(sum);
                    last[k + 1] = static_cast<std::uint8_t>(sum >> 8);
                }
            } else {
                const std::uint32_t bits = delta(0, i) | delta(1, i) << 8 | delta(2, i) << 16 | delta(3, i) << 24;
                const unsigned turn = how >> 4;
                const std::uint32_t turned = bits >> turn | bits << ((32 - turn) & 31);
                for (std::size_t k = 0; k < 4; ++k)
                    last[k] ^= static_cast<std::uint8_t>(turned >> 8 * k);
            }
            for (std::size_t k = 0; k < 4; ++k)
                byteAt(into, k) = last[k];
        }
    }

    StopCheck m_stopCheck;
    std::size_t m_count, m_stride;
    MeshoptBytes m_bytes;
    bool m_isFirstVersion = false;
    std::array<std::uint8_t, maxStride> m_last{};         ///< the previous element
    std::array<std::uint8_t, maxStride / 4> m_channels{}; ///< way of combining the deltas of each group of four bytes
    /// Deltas of a block, indexed by byte and element.
    std::array<std::array<std::uint8_t, maxBlock>, maxStride> m_deltas{};
};
} // namespace

std::string meshoptAttributes(const FileBytes& file, const MeshoptView& view)
{
    return AttributeReader(file, view).read();
}
} // namespace core::io
