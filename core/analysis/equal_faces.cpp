#include "core/analysis/equal_faces.h"

#include "core/util/parallel.h"
#include "core/util/radix_sort.h"

#include <algorithm>
#include <tuple>

namespace core
{
namespace
{
struct Key
{
    std::uint64_t least; ///< smallest corner
    Slot second, third;  ///< the other two corners, ascending
    Slot face;

    auto corners() const { return std::tie(least, second, third); }
    auto order() const { return std::tie(second, third, face); } ///< among those with the same smallest corner
};

std::vector<Key> keysOf(std::span<const Triangle> triangles, const std::vector<Slot>& faces)
{
    constexpr std::size_t chunkSize = 1 << 14;
    std::vector<Key> keys(faces.size());
    forEachChunk(faces.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Triangle t = triangles[faces[i]];
            std::ranges::sort(t);
            keys[i] = {t[0], t[1], t[2], faces[i]};
        }
    });
    return keys;
}
} // namespace

EqualFaces::EqualFaces(std::span<const Triangle> triangles, const std::vector<Slot>& faces)
{
    std::vector<Key> keys = keysOf(triangles, faces);
    radixSort(keys, &Key::least);
    for (auto begin = keys.begin(), end = begin; begin != keys.end(); begin = end) {
        end = std::find_if(begin, keys.end(), [&](const Key& key) { return key.least != begin->least; });
        std::sort(begin, end, [](const Key& a, const Key& b) { return a.order() < b.order(); });
    }
    m_faces.reserve(keys.size());
    for (const Key& key : keys) {
        if (m_faces.empty() || key.corners() != (&key - 1)->corners())
            m_begins.push_back(static_cast<Slot>(m_faces.size()));
        m_faces.push_back(key.face);
    }
    m_begins.push_back(static_cast<Slot>(m_faces.size()));
}
} // namespace core
