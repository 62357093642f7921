#pragma once

#include "core/mesh/mesh.h"
#include "core/util/sparse_index.h"

#include <vector>

namespace core
{
/// Searches for short cycles of edges that do not separate the surface. Each such cycle runs around a tunnel or around
/// a handle. Owns scratch memory.
class CycleSearch
{
public:
    enum class Around { Tunnel, Handle };

    /// Returns the vertices, in order, of a short cycle of this kind through v or near it. Returns nothing if none at
    /// most `maxLength` (mm) long is found, or if more than 512 vertices of `among` are within half that length. All
    /// vertices of the cycle are in `among`.
    /// Precondition: v is live and in `among`.
    /// Source: the greedy basis of cycles at a vertex, Erickson and Whittlesey 2005.
    /// Cost: the vertices within half the length; and for each of at most 8 cycles, at most 8192 faces on either side
    /// of it.
    std::vector<Slot> find(const Mesh& mesh, const SlotSet& among, Slot v, Around kind, double maxLength);

private:
    /// An edge that, with the shortest paths from the source to its ends, closes a cycle.
    struct Closing
    {
        double length = 0; ///< length of the cycle, mm
        Slot halfedge = noSlot;
    };

    bool reach(const Mesh& mesh, const SlotSet& among, Slot source, double radius);
    void findClosings(const Mesh& mesh);
    void keepEssential(const Mesh& mesh);
    Slot nodeOf(const Mesh& mesh, Slot face);
    Slot rootOf(Slot node);
    std::vector<Slot> cycleOf(const Mesh& mesh, Slot halfedge) const;
    bool isSeparating(const Mesh& mesh, const std::vector<Slot>& cycle);

    SparseIndex m_reached; ///< vertices reached by Dijkstra's algorithm
    std::vector<double> m_distance;
    std::vector<Slot> m_parent;
    std::vector<Closing> m_closings;
    SparseIndex m_faces; ///< faces with all three corners reached
    /// union-find parents of the faces' nodes; node 0 stands for all faces that were not reached
    std::vector<Slot> m_roots;
    SlotSet m_left, m_right, m_edges;
};
} // namespace core
