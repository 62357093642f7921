#pragma once

#include "core/repair/exact_point.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace core::repair
{
/// A triangle with points and segments in it, cut into triangles of which those are corners and edges. Exact. Points
/// are inserted one by one; segments are forced by flips (Sloan 1993); free edges are then flipped towards Delaunay's.
class PlanarTriangulation
{
public:
    /// `corners` go counter-clockwise in the projection. Lasting references.
    PlanarTriangulation(const ExactPoints& points, const Triangle& corners, Projection onto);

    /// Inside of the triangle or on its border. Once each.
    void insert(Slot point);
    /// Both ends are in, and no point lies between them; it crosses no segment that was forced before.
    void force(Slot from, Slot to);
    void improve();

    /// Counter-clockwise in the projection.
    std::vector<Triangle> triangles() const;

private:
    using Index = std::uint32_t;
    static constexpr Index none = noSlot;
    static constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
    static constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }

    struct Cell
    {
        Triangle corners;
        std::array<Index, 3> beyond{none, none, none}; ///< the cell across the edge that begins at the corner
        std::array<bool, 3> forced{};                  ///< that edge
    };
    struct Edge
    {
        Index cell;
        int edge; ///< begins at that corner
    };

    int side(Slot a, Slot b, Slot c) const { return orient2d(m_points[a], m_points[b], m_points[c], m_onto); }
    /// Of a cell that the point is in, and by which edge it lies on that one.
    struct Place
    {
        Index cell;
        std::array<int, 3> sides;
    };
    Place locate(Slot point) const;
    std::array<int, 3> sidesOf(const Cell& cell, Slot point) const;
    void splitCell(Index cell, Slot point);
    void splitEdge(Edge edge, Slot point);
    void link(Index cell, int edge, Index other, Slot otherFrom);
    int edgeFrom(Index cell, Slot from) const;
    Edge twin(Edge edge) const;
    bool isConvex(Edge edge) const;
    void flip(Edge edge);
    bool wantsFlip(Edge edge) const;
    void noteCorners(Index cell);
    template <typename Visit> void forEachEdgeFrom(Slot point, Visit visit) const;
    std::vector<std::pair<Slot, Slot>> crossedBy(Slot from, Slot to) const;
    std::optional<Edge> find(Slot from, Slot to) const;

    const ExactPoints& m_points;
    Projection m_onto;
    std::vector<Cell> m_cells;
    std::unordered_map<Slot, Index> m_cellAt; ///< a cell that has the point
    mutable Index m_last = 0;
};
} // namespace core::repair
