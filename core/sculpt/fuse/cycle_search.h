#pragma once

#include "core/mesh/mesh.h"
#include "core/util/sparse_index.h"

#include <vector>

namespace core
{
/// Searches for short cycles of edges that do not separate the surface: each runs around a tunnel or around a handle.
/// Owns scratch memory.
class CycleSearch
{
public:
    enum class Around { Tunnel, Handle };

    /// Returns the vertices of a short cycle of that kind, at v or near it, in order; nothing if none is found that is
    /// at most `maxLength` long (mm), or if more than 512 vertices lie so near. All its vertices are `among` these.
    /// Precondition: v is live, and one of them. Source: the greedy basis of cycles at a vertex, Erickson and
    /// Whittlesey 2005. Cost: the vertices within half the length, and for each of at most 8 cycles the faces on both
    /// sides until these meet, at most 8192 on each.
    std::vector<Slot> find(const Mesh& mesh, const SlotSet& among, Slot v, Around kind, double maxLength);

private:
    /// An edge that closes a cycle with the shortest paths from the source.
    struct Closing
    {
        double length = 0; ///< of the cycle
        Slot halfedge = noSlot;
    };

    bool reach(const Mesh& mesh, const SlotSet& among, Slot source, double radius);
    void findClosings(const Mesh& mesh);
    void keepEssential(const Mesh& mesh);
    Slot nodeOf(const Mesh& mesh, Slot face);
    Slot rootOf(Slot node);
    std::vector<Slot> cycleOf(const Mesh& mesh, Slot halfedge) const;
    bool isSeparating(const Mesh& mesh, const std::vector<Slot>& cycle);

    SparseIndex m_reached; ///< vertices, by distance from the source
    std::vector<double> m_distance;
    std::vector<Slot> m_parent;
    std::vector<Closing> m_closings;
    SparseIndex m_faces;       ///< with three corners reached
    std::vector<Slot> m_roots; ///< of sets of faces; the first is of all that was not reached
    SlotSet m_left, m_right, m_edges;
};
} // namespace core
