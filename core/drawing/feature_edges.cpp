// Finds the edges that are lines of a drawing without storing the mesh's connectivity. An edge can be an
// outline only if both of its vertices have faces towards the eye and faces away from it. An edge can be a crease only
// if the normals of both vertices differ much from the normal of a face. Only the faces at such edges are paired.
#include "core/drawing/feature_edges.h"

#include "core/drawing/depth_image.h"

#include <algorithm>
#include <array>
#include <functional>
#include <future>
#include <numeric>

namespace core
{
namespace
{
constexpr std::size_t blocksPerStep = 64; ///< blocks processed between two checks of `stop`
constexpr std::uint8_t sidesMask = 7, awayShift = 3, sharpBit = 1 << 6;
constexpr double sharpCosine = halfCreaseCosine + 0.012; ///< allows for vertex normals that are rounded to 1/127

std::uint8_t facingOf(const Vec3& normal)
{
    return static_cast<std::uint8_t>((normal.z() > 0) | (normal.x() > 0) << 1 | (normal.y() > 0) << 2);
}

/// Returns whether the angle between the face's and the vertex's normal is more than half the crease angle.
bool isSharp(const DrawVertex& vertex, const Vec3f& normal, float length2)
{
    const Vec3f mean(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
    const float along = mean.dot(normal);
    constexpr auto min = static_cast<float>(sharpCosine * sharpCosine);
    return along <= 0 || along * along < min * length2 * mean.squaredNorm();
}

constexpr std::size_t blocksOf(std::size_t faces)
{
    return (faces + facesPerBlock - 1) / facesPerBlock;
}

/// Calls work(slot) for all faces of a block that exist.
template <class Work> void eachFace(const DrawArrays& model, std::size_t block, Work work)
{
    const std::size_t first = block * facesPerBlock, end = std::min(model.faces.size(), first + facesPerBlock);
    for (std::size_t f = first; f < end; ++f)
        if (const auto slot = static_cast<Slot>(f); !model.isFree(slot))
            work(slot);
}

/// Calls work(half, block) for all blocks. Each half of the blocks runs on a thread of its own. Returns false if it was
/// stopped.
template <class Work> bool eachBlock(std::size_t blocks, const std::stop_token& stop, Work work)
{
    const auto run = [&](std::size_t half, std::size_t first, std::size_t end) {
        for (std::size_t block = first; block < end; ++block) {
            if (block % blocksPerStep == 0 && stop.stop_requested())
                return false;
            work(half, block);
        }
        return true;
    };
    auto aside = std::async(std::launch::async, run, 1, blocks / 2, blocks);
    const bool isDone = run(0, 0, blocks / 2);
    return aside.get() && isDone;
}

bool bends(const DrawArrays& model, Slot f, Slot g)
{
    const Vec3 m = drawnNormal(model, f), n = drawnNormal(model, g);
    const double along = m.dot(n);
    return along <= 0 || along * along < creaseCosine * creaseCosine * m.squaredNorm() * n.squaredNorm();
}
} // namespace

Vec3 drawnNormal(const DrawArrays& model, Slot face)
{
    const Triangle& t = model.faces[face];
    const Vec3 a = model.vertices[t[0]].position.cast<double>();
    return (model.vertices[t[1]].position.cast<double>() - a).cross(model.vertices[t[2]].position.cast<double>() - a);
}

bool FeatureScan::scan(const DrawArrays& model, const std::stop_token& stop)
{
    m_facing.assign(model.faces.size(), 0);
    m_blocks.assign(blocksOf(model.faces.size()), Box());
    m_corners.assign(m_blocks.size(), {});
    m_volumes.assign(m_blocks.size(), 0);
    std::array<Marks, 2> marks{Marks(model.vertices.size(), 0), Marks(model.vertices.size(), 0)};
    const auto look = [&](std::size_t half, std::size_t block) {
        measure(model, block);
        eachFace(model, block, [&](Slot f) { mark(model, f, marks[half]); });
    };
    if (!eachBlock(m_blocks.size(), stop, look))
        return false;
    m_marks = std::move(marks[0]);
    std::ranges::transform(m_marks, marks[1], m_marks.begin(), std::bit_or<std::uint8_t>());
    m_hasCreases = true;
    if (!collect(model, stop))
        return false;
    if (m_halfEdges.size() / 2 > m_maxEdges) {
        m_hasCreases = false;
        if (!collect(model, stop))
            return false;
    }
    pair(model);
    return true;
}

bool FeatureScan::rescan(const DrawArrays& model, const DrawnChange& change)
{
    m_facing.resize(model.faces.size());
    m_marks.resize(model.vertices.size());
    m_blocks.resize(blocksOf(model.faces.size()));
    m_corners.resize(m_blocks.size());
    m_volumes.resize(m_blocks.size());
    for (std::size_t i = 0; i < change.faces.size(); ++i)
        if (i == 0 || change.faces[i] / facesPerBlock != change.faces[i - 1] / facesPerBlock)
            measure(model, change.faces[i] / facesPerBlock);
    for (const Slot v : change.vertices)
        m_marks[v] = 0;
    for (const Slot f : change.around)
        mark(model, f, m_marks);
    const auto isOneOf = [](const std::vector<Slot>& faces, const HalfEdge& h) {
        return std::ranges::binary_search(faces, h.face);
    };
    std::erase_if(m_halfEdges,
                  [&](const HalfEdge& h) { return isOneOf(change.around, h) || isOneOf(change.faces, h); });
    const auto old = static_cast<std::ptrdiff_t>(m_halfEdges.size());
    for (const Slot f : change.around)
        addHalfEdges(model.faces[f], f, m_halfEdges);
    std::sort(m_halfEdges.begin() + old, m_halfEdges.end());
    std::inplace_merge(m_halfEdges.begin(), m_halfEdges.begin() + old, m_halfEdges.end());
    if (m_hasCreases && m_halfEdges.size() / 2 > m_maxEdges)
        return false;
    pair(model);
    return true;
}

std::vector<Slot> FeatureScan::facesAt(std::span<const Slot> vertices, const DrawArrays& model) const
{
    std::vector<bool> isOne(
        vertices.empty() ? 0 : std::max<std::size_t>(model.vertices.size(), vertices.back() + std::size_t(1)), false);
    for (const Slot v : vertices)
        isOne[v] = true;
    std::vector<Slot> faces;
    for (std::size_t block = 0; block < m_blocks.size(); ++block) {
        const auto [first, last] = m_corners[block];
        if (const auto next = std::ranges::lower_bound(vertices, first); next == vertices.end() || *next > last)
            continue;
        eachFace(model, block, [&](Slot f) {
            const Triangle& t = model.faces[f];
            if (isOne[t[0]] || isOne[t[1]] || isOne[t[2]])
                faces.push_back(f);
        });
    }
    return faces;
}

/// Measures one block: the directions of its faces, its range of vertex slots, its box and its volume.
void FeatureScan::measure(const DrawArrays& model, std::size_t block)
{
    const std::size_t first = block * facesPerBlock, end = std::min(model.faces.size(), first + facesPerBlock);
    std::fill(m_facing.begin() + static_cast<std::ptrdiff_t>(first),
              m_facing.begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t(0));
    Box box;
    double volume = 0;
    std::pair<Slot, Slot> corners{noSlot, 0};
    eachFace(model, block, [&](Slot f) {
        const Vec3 normal = drawnNormal(model, f);
        m_facing[f] = facingOf(normal);
        for (const Slot v : model.faces[f]) {
            box.extend(model.vertices[v].position.cast<double>());
            corners = {std::min(corners.first, v), std::max(corners.second, v)};
        }
        volume += model.vertices[model.faces[f][0]].position.cast<double>().dot(normal);
    });
    m_blocks[block] = box;
    m_corners[block] = corners;
    m_volumes[block] = volume;
}

void FeatureScan::mark(const DrawArrays& model, Slot f, Marks& marks) const
{
    const std::uint8_t facing = m_facing[f];
    const auto sides = static_cast<std::uint8_t>(facing | (~facing & sidesMask) << awayShift);
    const Vec3f normal = drawnNormal(model, f).cast<float>();
    const float length2 = normal.squaredNorm();
    for (const Slot v : model.faces[f])
        marks[v] =
            static_cast<std::uint8_t>(marks[v] | sides | (isSharp(model.vertices[v], normal, length2) ? sharpBit : 0));
}

bool FeatureScan::mayBeLine(Slot a, Slot b) const
{
    const auto both = static_cast<std::uint8_t>(m_marks[a] & m_marks[b]);
    return (both & both >> awayShift & sidesMask) != 0 || (m_hasCreases && (both & sharpBit) != 0);
}

void FeatureScan::addHalfEdges(const Triangle& t, Slot f, std::vector<HalfEdge>& to) const
{
    for (std::size_t i = 0; i < 3; ++i)
        if (const Slot a = t[i], b = t[(i + 1) % 3]; mayBeLine(a, b))
            to.push_back({std::min(a, b), std::max(a, b), f});
}

/// Collects the half-edges that may be lines. Gives up as soon as there are too many for creases. Returns false if it
/// was stopped.
bool FeatureScan::collect(const DrawArrays& model, const std::stop_token& stop)
{
    std::array<std::vector<HalfEdge>, 2> found;
    const auto look = [&](std::size_t half, std::size_t block) {
        if (!m_hasCreases || found[half].size() / 2 <= m_maxEdges)
            eachFace(model, block, [&](Slot f) { addHalfEdges(model.faces[f], f, found[half]); });
    };
    if (!eachBlock(m_blocks.size(), stop, look))
        return false;
    m_halfEdges = std::move(found[0]);
    m_halfEdges.insert(m_halfEdges.end(), found[1].begin(), found[1].end());
    if (!m_hasCreases || m_halfEdges.size() / 2 <= m_maxEdges)
        std::ranges::sort(m_halfEdges);
    return true;
}

void FeatureScan::pair(const DrawArrays& model)
{
    m_edges.clear();
    for (std::size_t i = 0; i + 1 < m_halfEdges.size(); ++i) {
        const HalfEdge &one = m_halfEdges[i], &other = m_halfEdges[i + 1];
        if (one.a != other.a || one.b != other.b)
            continue;
        const auto outline = static_cast<std::uint8_t>(m_facing[one.face] ^ m_facing[other.face]);
        const bool isCrease = m_hasCreases && bends(model, one.face, other.face);
        if (outline != 0 || isCrease)
            m_edges.push_back({one.a, one.b, {one.face, other.face}, outline, isCrease});
        ++i;
    }
}

Box FeatureScan::box() const
{
    Box box;
    for (const Box& block : m_blocks)
        box.extend(block);
    return box;
}

double FeatureScan::volume() const
{
    return std::accumulate(m_volumes.begin(), m_volumes.end(), 0.0) / 6;
}
} // namespace core
