#pragma once

#include "core/repair/exact_point.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace core::repair
{
/// A triangle divided into triangles, with given points as corners and given segments as edges. Exact. Points are
/// inserted one by one, segments are forced by flips (Sloan 1993), and other edges are then flipped towards Delaunay.
class PlanarTriangulation
{
public:
    /// Precondition: `corners` are counter-clockwise in the projection. Keeps a reference to `points`.
    PlanarTriangulation(const ExactPoints& points, const Triangle& corners, Projection onto);

    /// Inserts a point. Precondition: it is inside the triangle or on its border, and not yet inserted.
    void insert(Slot point);
    /// Makes the segment an edge. Precondition: both ends are inserted, no point is between them, and the segment
    /// crosses no forced segment.
    void force(Slot from, Slot to);
    void improve();

    /// Returns the triangles, counter-clockwise in the projection.
    std::vector<Triangle> triangles() const;

private:
    using Index = std::uint32_t;
    static constexpr Index none = noSlot;
    static constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
    static constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }

    struct Cell
    {
        Triangle corners;
        std::array<Index, 3> beyond{none, none, none}; ///< the cell across the edge that begins at each corner
        std::array<bool, 3> forced{};                  ///< whether the edge that begins at each corner is forced
    };
    struct Edge
    {
        Index cell;
        int edge; ///< index of the corner at which the edge begins
    };

    int side(Slot a, Slot b, Slot c) const { return orient2d(m_points[a], m_points[b], m_points[c], m_onto); }
    /// A cell that contains a point, and on which side of each edge of the cell the point is.
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
    std::unordered_map<Slot, Index> m_cellAt; ///< a cell that has the point as a corner
    mutable Index m_last = 0;
};
} // namespace core::repair
