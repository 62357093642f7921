#include "core/repair/planar_triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <optional>

namespace core::repair
{
PlanarTriangulation::PlanarTriangulation(const ExactPoints& points, const Triangle& corners, Projection onto)
    : m_points(points)
    , m_onto(onto)
    , m_cells{Cell{corners}}
{
    m_cells[0].forced = {true, true, true};
    noteCorners(0);
}

/// Stores the cell as the known cell of each of its corners.
void PlanarTriangulation::noteCorners(Index cell)
{
    for (const Slot corner : m_cells[cell].corners)
        m_cellAt[corner] = cell;
}

std::array<int, 3> PlanarTriangulation::sidesOf(const Cell& cell, Slot point) const
{
    std::array<int, 3> sides;
    for (int i = 0; i < 3; ++i)
        sides[i] = side(cell.corners[i], cell.corners[next(i)], point);
    return sides;
}

/// Walks from cell to cell towards the point. If the walk does not end, tests every cell.
PlanarTriangulation::Place PlanarTriangulation::locate(Slot point) const
{
    const auto isIn = [](const std::array<int, 3>& sides) { return sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0; };
    Index cell = m_last;
    for (std::size_t steps = 0; steps < m_cells.size(); ++steps) {
        const std::array<int, 3> sides = sidesOf(m_cells[cell], point);
        if (isIn(sides))
            return {m_last = cell, sides};
        Index beyond = none;
        for (int k = 0; k < 3 && beyond == none; ++k) {
            const auto i = static_cast<std::size_t>((k + static_cast<int>(steps)) % 3);
            beyond = sides[i] < 0 ? m_cells[cell].beyond[i] : none;
        }
        if (beyond == none)
            break;
        cell = beyond;
    }
    for (cell = 0; cell < m_cells.size(); ++cell) {
        if (const std::array<int, 3> sides = sidesOf(m_cells[cell], point); isIn(sides))
            return {m_last = cell, sides};
    }
    assert(false && "the point lies in the triangle");
    return {0, {1, 1, 1}};
}

void PlanarTriangulation::insert(Slot point)
{
    const auto [cell, sides] = locate(point);
    const auto on = std::ranges::find(sides, 0);
    if (on == sides.end())
        splitCell(cell, point);
    else
        splitEdge({cell, static_cast<int>(on - sides.begin())}, point);
}

int PlanarTriangulation::edgeFrom(Index cell, Slot from) const
{
    const Triangle& corners = m_cells[cell].corners;
    return static_cast<int>(std::ranges::find(corners, from) - corners.begin());
}

PlanarTriangulation::Edge PlanarTriangulation::twin(Edge edge) const
{
    const Cell& cell = m_cells[edge.cell];
    const Index other = cell.beyond[edge.edge];
    return {other, other == none ? 0 : edgeFrom(other, cell.corners[next(edge.edge)])};
}

/// Makes `cell` and `other`, if it exists, neighbours: across `edge` of the cell, and across the edge of `other` that
/// begins at `otherFrom`.
void PlanarTriangulation::link(Index cell, int edge, Index other, Slot otherFrom)
{
    m_cells[cell].beyond[edge] = other;
    if (other != none)
        m_cells[other].beyond[edgeFrom(other, otherFrom)] = cell;
}

void PlanarTriangulation::splitCell(Index cell, Slot point)
{
    const Cell old = m_cells[cell];
    const auto first = static_cast<Index>(m_cells.size());
    const std::array<Index, 3> parts{cell, first, first + 1};
    m_cells.resize(m_cells.size() + 2);
    for (int i = 0; i < 3; ++i) {
        Cell& part = m_cells[parts[i]] = Cell{{old.corners[i], old.corners[next(i)], point}};
        part.beyond = {none, parts[next(i)], parts[previous(i)]};
        part.forced = {old.forced[i], false, false};
    }
    for (int i = 0; i < 3; ++i) {
        link(parts[i], 0, old.beyond[i], old.corners[next(i)]);
        noteCorners(parts[i]);
    }
}

void PlanarTriangulation::splitEdge(Edge edge, Slot point)
{
    const Edge other = twin(edge);
    const auto halve = [&](Edge e) -> std::pair<Index, Index> { // cells before and after the point along the edge
        const Cell old = m_cells[e.cell];
        const Slot from = old.corners[e.edge], to = old.corners[next(e.edge)], apex = old.corners[previous(e.edge)];
        const auto added = static_cast<Index>(m_cells.size());
        m_cells.emplace_back();
        m_cells[e.cell] = Cell{{from, point, apex}};
        m_cells[added] = Cell{{point, to, apex}};
        m_cells[e.cell].forced = {old.forced[e.edge], false, old.forced[previous(e.edge)]};
        m_cells[added].forced = {old.forced[e.edge], old.forced[next(e.edge)], false};
        m_cells[e.cell].beyond[1] = added;
        m_cells[added].beyond[2] = e.cell;
        link(e.cell, 2, old.beyond[previous(e.edge)], from);
        link(added, 1, old.beyond[next(e.edge)], apex);
        noteCorners(e.cell);
        noteCorners(added);
        return {e.cell, added};
    };
    const auto [before, after] = halve(edge);
    if (other.cell == none)
        return;
    const auto [otherBefore, otherAfter] = halve(other);
    m_cells[before].beyond[0] = otherAfter;
    m_cells[otherAfter].beyond[0] = before;
    m_cells[after].beyond[0] = otherBefore;
    m_cells[otherBefore].beyond[0] = after;
}

/// Returns whether the two cells at the edge form a strictly convex quadrilateral.
bool PlanarTriangulation::isConvex(Edge edge) const
{
    const Edge other = twin(edge);
    const Cell& cell = m_cells[edge.cell];
    const Slot from = cell.corners[edge.edge], to = cell.corners[next(edge.edge)];
    const Slot apex = cell.corners[previous(edge.edge)], across = m_cells[other.cell].corners[previous(other.edge)];
    return side(apex, from, across) > 0 && side(across, to, apex) > 0;
}

void PlanarTriangulation::flip(Edge edge)
{
    const Edge other = twin(edge);
    const Cell cell = m_cells[edge.cell], opposite = m_cells[other.cell];
    const int a = edge.edge, b = other.edge;
    const Slot from = cell.corners[a], to = cell.corners[next(a)];
    const Slot apex = cell.corners[previous(a)], across = opposite.corners[previous(b)];
    Cell& first = m_cells[edge.cell] = Cell{{apex, from, across}};
    Cell& second = m_cells[other.cell] = Cell{{across, to, apex}};
    first.forced = {cell.forced[previous(a)], opposite.forced[next(b)], false};
    second.forced = {opposite.forced[previous(b)], cell.forced[next(a)], false};
    first.beyond[2] = other.cell;
    second.beyond[2] = edge.cell;
    link(edge.cell, 0, cell.beyond[previous(a)], from);
    link(edge.cell, 1, opposite.beyond[next(b)], across);
    link(other.cell, 0, opposite.beyond[previous(b)], to);
    link(other.cell, 1, cell.beyond[next(a)], apex);
    noteCorners(edge.cell);
    noteCorners(other.cell);
}

/// Calls visit(edge) for each edge that begins at the point, until visit returns true.
template <typename Visit> void PlanarTriangulation::forEachEdgeFrom(Slot point, Visit visit) const
{
    const Index start = m_cellAt.at(point);
    Index cell = start;
    do {
        const int i = edgeFrom(cell, point);
        if (visit(Edge{cell, i}))
            return;
        cell = m_cells[cell].beyond[previous(i)];
    } while (cell != none && cell != start);
    if (cell == start)
        return;
    for (cell = m_cells[start].beyond[edgeFrom(start, point)]; cell != none; // from the border in the other direction
         cell = m_cells[cell].beyond[edgeFrom(cell, point)])
        if (visit(Edge{cell, edgeFrom(cell, point)}))
            return;
}

std::optional<PlanarTriangulation::Edge> PlanarTriangulation::find(Slot from, Slot to) const
{
    std::optional<Edge> found;
    forEachEdgeFrom(from, [&](Edge edge) {
        if (m_cells[edge.cell].corners[next(edge.edge)] == to)
            found = edge;
        return found.has_value();
    });
    return found;
}

/// Returns the edges that the segment crosses, in order from its beginning to its end.
std::vector<std::pair<Slot, Slot>> PlanarTriangulation::crossedBy(Slot from, Slot to) const
{
    std::optional<Edge> edge; // its beginning is right of the segment, its end left
    forEachEdgeFrom(from, [&](Edge e) {
        const Triangle& corners = m_cells[e.cell].corners;
        if (side(from, to, corners[next(e.edge)]) < 0 && side(from, to, corners[previous(e.edge)]) > 0)
            edge = {e.cell, next(e.edge)};
        return edge.has_value();
    });
    std::vector<std::pair<Slot, Slot>> crossed;
    while (edge) {
        crossed.emplace_back(m_cells[edge->cell].corners[edge->edge], m_cells[edge->cell].corners[next(edge->edge)]);
        const Edge other = twin(*edge);
        const Slot apex = m_cells[other.cell].corners[previous(other.edge)];
        if (apex == to)
            break;
        edge = Edge{other.cell, side(from, to, apex) > 0 ? next(other.edge) : previous(other.edge)};
    }
    return crossed;
}

void PlanarTriangulation::force(Slot from, Slot to)
{
    std::deque<std::pair<Slot, Slot>> crossed;
    if (!find(from, to) && !find(to, from))
        std::ranges::copy(crossedBy(from, to), std::back_inserter(crossed));
    while (!crossed.empty()) {
        const auto [a, b] = crossed.front();
        crossed.pop_front();
        const Edge edge = *find(a, b);
        if (!isConvex(edge)) {
            crossed.emplace_back(a, b);
            continue;
        }
        const Slot apex = m_cells[edge.cell].corners[previous(edge.edge)];
        const Edge other = twin(edge);
        const Slot across = m_cells[other.cell].corners[previous(other.edge)];
        flip(edge);
        const bool isEnd = apex == from || apex == to || across == from || across == to;
        if (!isEnd && side(from, to, apex) * side(from, to, across) < 0)
            crossed.emplace_back(across, apex);
    }
    for (const auto& edge : {find(from, to), find(to, from)}) {
        if (edge)
            m_cells[edge->cell].forced[edge->edge] = true;
    }
}

/// Returns whether the angles opposite the edge sum up to more than half a turn, where the sine of the sum is negative.
/// Uses doubles, because the result only affects the shape of the triangles.
bool PlanarTriangulation::wantsFlip(Edge edge) const
{
    const Edge other = twin(edge);
    const Cell& cell = m_cells[edge.cell];
    const Vec3 &from = m_points[cell.corners[edge.edge]].approx, &to = m_points[cell.corners[next(edge.edge)]].approx;
    const auto sineAndCosine = [&](Slot apex) {
        const Vec3 u = from - m_points[apex].approx, v = to - m_points[apex].approx;
        return std::pair(u.cross(v).norm(), u.dot(v));
    };
    const auto [sine, cosine] = sineAndCosine(cell.corners[previous(edge.edge)]);
    const auto [otherSine, otherCosine] = sineAndCosine(m_cells[other.cell].corners[previous(other.edge)]);
    constexpr double slack = 1e-9;
    return sine * otherCosine + cosine * otherSine <
           -slack * (sine + std::abs(cosine)) * (otherSine + std::abs(otherCosine));
}

void PlanarTriangulation::improve()
{
    constexpr int rounds = 8; // moves towards Delaunay; need not reach it
    bool flipped = true;
    for (int round = 0; round < rounds && flipped; ++round) {
        flipped = false;
        for (Index cell = 0; cell < m_cells.size(); ++cell) {
            for (int i = 0; i < 3; ++i) {
                const Edge edge{cell, i};
                if (m_cells[cell].forced[i] || m_cells[cell].beyond[i] == none || !wantsFlip(edge) || !isConvex(edge))
                    continue;
                flip(edge);
                flipped = true;
            }
        }
    }
}

std::vector<Triangle> PlanarTriangulation::triangles() const
{
    std::vector<Triangle> result;
    for (const Cell& cell : m_cells)
        result.push_back(cell.corners);
    return result;
}
} // namespace core::repair
