#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <unordered_map>

namespace core
{
/// Remembers edges of a decimation that could not collapse because faces elsewhere were in the way. The same collapse
/// would fail again as long as neither those faces nor the edge's surroundings change, so it is not tried.
class BlockedEdges
{
public:
    /// `stamps`: number of changes so far, by vertex. Both references must outlive this object.
    BlockedEdges(const Mesh& mesh, const std::vector<std::uint32_t>& stamps) : m_mesh(mesh), m_stamps(stamps) {}

    void clear() { m_edges.clear(); }
    /// Returns true if the edge from v0 to v1 was blocked and nothing that its collapse depended on has changed since.
    bool isBlocked(Slot v0, Slot v1) const;

    /// Begins an attempt to collapse an edge, to one place or several.
    void begin() { m_present = {}; }
    /// Records a place that failed. Stores one of the `badFaces` that does not touch the edge, if there is one.
    void note(const std::vector<Slot>& badFaces, Slot v0, Slot v1);
    /// Ends an attempt in which all places failed. Marks the edge as blocked if a recorded face was in the way.
    void keep(Slot v0, Slot v1);

private:
    struct Obstacle
    {
        std::array<Slot, 4> faces{}; ///< one face for each failed place that had a face in the way
        std::size_t count = 0;
        std::uint64_t changes = 0; ///< sum of the stamps that the attempt depended on, at the time it failed
    };
    static std::uint64_t keyOf(Slot v0, Slot v1) { return (std::uint64_t(v0) << 32) + v1; }
    std::uint64_t changesAround(const Obstacle& obstacle, Slot v0, Slot v1) const;

    const Mesh& m_mesh;
    const std::vector<std::uint32_t>& m_stamps;
    Obstacle m_present;
    std::unordered_map<std::uint64_t, Obstacle> m_edges;
};
} // namespace core
