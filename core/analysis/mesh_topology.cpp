// Examines each vertex by its own faces. They give its edges, each counted at the lower of its two vertices. They also
// link its neighbours; these links must form one connected piece.

#include "core/analysis/mesh_topology.h"

#include "core/util/parallel.h"
#include "core/util/smallest_k.h"

#include <numeric>

namespace core
{
namespace
{
constexpr std::size_t verticesPerChunk = 1 << 12;

/// The corners of all faces, grouped by vertex.
class Corners
{
public:
    struct Corner
    {
        Slot face, next, previous;
    };

    Corners(std::size_t vertices, std::span<const Triangle> triangles)
        : m_triangles(triangles)
        , m_first(vertices + 1, 0)
    {
        for (const Triangle& t : triangles)
            for (const Slot v : t)
                ++m_first[v + 1];
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
        m_corners.resize(3 * triangles.size());
        std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
        for (std::size_t f = 0; f < triangles.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                m_corners[next[triangles[f][i]]++] = 3 * f + i;
    }

    std::size_t begin(std::size_t vertex) const { return m_first[vertex]; }
    std::size_t end(std::size_t vertex) const { return m_first[vertex + 1]; }
    Corner operator[](std::size_t i) const
    {
        const std::size_t face = m_corners[i] / 3, corner = m_corners[i] % 3;
        const Triangle& t = m_triangles[face];
        return {static_cast<Slot>(face), t[corner == 2 ? 0 : corner + 1], t[corner == 0 ? 2 : corner - 1]};
    }

private:
    std::span<const Triangle> m_triangles;
    std::vector<std::size_t> m_first;
    std::vector<std::size_t> m_corners; ///< 3 x face + corner
};

using Faces = SmallestK<Slot>;

struct Counts
{
    std::size_t vertices = 0;
    std::uint64_t edges = 0;
    Faces open{Finding::maxFirst}, tooMany{Finding::maxFirst}, split{Finding::maxFirst}, misoriented{Finding::maxFirst};

    void add(const Counts& other)
    {
        vertices += other.vertices;
        edges += other.edges;
        open.add(other.open);
        tooMany.add(other.tooMany);
        split.add(other.split);
        misoriented.add(other.misoriented);
    }
};

/// Counts the edges and defects of one vertex after another; reuses its buffers.
class VertexInspector
{
public:
    VertexInspector(const Corners& corners, Counts& counts) : m_corners(corners), m_counts(counts) {}

    void inspect(Slot vertex)
    {
        const std::size_t begin = m_corners.begin(vertex), end = m_corners.end(vertex);
        if (begin == end)
            return;
        ++m_counts.vertices;
        m_spokes.clear();
        for (std::size_t i = begin; i < end; ++i) {
            const Corners::Corner c = m_corners[i];
            m_spokes.push_back({c.next, c.face, true});
            m_spokes.push_back({c.previous, c.face, false});
        }
        std::sort(m_spokes.begin(), m_spokes.end());
        countEdges(vertex);
        if (umbrellas(begin, end) > 1)
            m_counts.split.add(m_corners[begin].face);
    }

private:
    struct Spoke
    {
        Slot neighbour, face;
        bool outgoing;
        friend auto operator<=>(const Spoke&, const Spoke&) = default;
    };

    void countEdges(Slot vertex)
    {
        m_neighbours.clear();
        for (std::size_t i = 0, next = 0; i < m_spokes.size(); i = next) {
            const Spoke& spoke = m_spokes[i];
            std::size_t outgoing = 0;
            for (; next < m_spokes.size() && m_spokes[next].neighbour == spoke.neighbour; ++next)
                outgoing += m_spokes[next].outgoing;
            m_neighbours.push_back(spoke.neighbour);
            if (spoke.neighbour > vertex)
                countEdge(spoke.face, next - i, outgoing);
        }
    }

    void countEdge(Slot face, std::size_t faces, std::size_t outgoing)
    {
        ++m_counts.edges;
        if (faces == 1)
            m_counts.open.add(face);
        else if (faces > 2)
            m_counts.tooMany.add(face);
        else if (outgoing != 1)
            m_counts.misoriented.add(face);
    }

    /// Returns the number of sets of neighbours that are connected by the faces around the vertex.
    std::size_t umbrellas(std::size_t begin, std::size_t end)
    {
        m_parent.resize(m_neighbours.size());
        std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
        std::size_t sets = m_neighbours.size();
        for (std::size_t i = begin; i < end; ++i) {
            const Corners::Corner c = m_corners[i];
            const std::size_t a = root(indexOf(c.next)), b = root(indexOf(c.previous));
            sets -= a != b;
            m_parent[a] = b;
        }
        return sets;
    }

    std::size_t indexOf(Slot neighbour) const
    {
        const auto found = std::lower_bound(m_neighbours.begin(), m_neighbours.end(), neighbour);
        return static_cast<std::size_t>(found - m_neighbours.begin());
    }

    std::size_t root(std::size_t i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }

    const Corners& m_corners;
    Counts& m_counts;
    std::vector<Spoke> m_spokes;
    std::vector<Slot> m_neighbours;
    std::vector<std::size_t> m_parent;
};

Finding toFinding(Faces& faces)
{
    return {faces.count(), faces.take()};
}
} // namespace

MeshTopology topologyOf(std::size_t vertices, std::span<const Triangle> triangles)
{
    const Corners corners(vertices, triangles);
    std::vector<Counts> parts(chunksOf(vertices, verticesPerChunk));
    forEachChunk(vertices, verticesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        VertexInspector inspector(corners, parts[chunk]);
        for (std::size_t v = begin; v < end; ++v)
            inspector.inspect(static_cast<Slot>(v));
    });
    Counts all;
    for (const Counts& part : parts)
        all.add(part);
    return {all.vertices,         all.edges,
            toFinding(all.open),  toFinding(all.tooMany),
            toFinding(all.split), toFinding(all.misoriented)};
}
} // namespace core
