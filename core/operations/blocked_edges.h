#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <unordered_map>

namespace core
{
/// The edges of a decimation that could not collapse because faces elsewhere were in the way. As long as neither those
/// faces nor the edge's surroundings change, the same collapse would fail again, and need not be tried.
class BlockedEdges
{
public:
    /// `stamps`: by vertex, its changes so far. Lasting references.
    BlockedEdges(const Mesh& mesh, const std::vector<std::uint32_t>& stamps) : m_mesh(mesh), m_stamps(stamps) {}

    void clear() { m_edges.clear(); }
    /// Returns whether the edge from v0 to v1 was blocked, and nothing has changed there.
    bool isBlocked(Slot v0, Slot v1) const;

    /// Begins an attempt at an edge, with one place or several.
    void begin() { m_present = {}; }
    /// Notes a place that failed: one of the bad faces that is not at the edge, if there is any.
    void note(const std::vector<Slot>& badFaces, Slot v0, Slot v1);
    /// Ends an attempt of which all places failed.
    void keep(Slot v0, Slot v1);

private:
    struct Obstacle
    {
        std::array<Slot, 4> faces{}; ///< one for each place that met any
        std::size_t count = 0;
        std::uint64_t changes = 0; ///< of all that the attempt depended on, when it failed
    };
    static std::uint64_t keyOf(Slot v0, Slot v1) { return (std::uint64_t(v0) << 32) + v1; }
    std::uint64_t changesAround(const Obstacle& obstacle, Slot v0, Slot v1) const;

    const Mesh& m_mesh;
    const std::vector<std::uint32_t>& m_stamps;
    Obstacle m_present;
    std::unordered_map<std::uint64_t, Obstacle> m_edges;
};
} // namespace core
