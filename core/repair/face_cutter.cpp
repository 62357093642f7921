//   1. lines      at which the other faces meet this one: a segment, or the edges of an overlap in one plane
//   2. crossings  of these segments
//   3. cut        a triangulation with all points as corners and all segments as edges
//   4. cover      of pieces that overlap, only the piece of the face with the lowest index remains

#include "core/repair/face_cutter.h"

#include "core/repair/planar_triangulation.h"

#include "core/geometry/predicates.h"

#include <algorithm>
#include <optional>
#include <set>

namespace core::repair
{
namespace
{
using Corners = std::array<LatticePoint, 3>;
using Plane = LatticePredicates::Plane;

Corners cornersOf(const TriangleSoup& surface, Slot face)
{
    const Triangle& t = surface.triangles[face];
    return {surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
}

Plane planeOf(const Corners& c)
{
    return {c[0], c[1], c[2]};
}

std::array<int, 3> sidesOf(const Corners& corners, const Plane& plane)
{
    return {plane.side(corners[0]), plane.side(corners[1]), plane.side(corners[2])};
}

/// Returns the points, at most two, where the triangle's border meets the plane of the other triangle.
std::vector<ExactPoint> borderOn(const Corners& corners, const std::array<int, 3>& sides, const Corners& plane)
{
    std::vector<ExactPoint> points;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = i == 2 ? 0 : i + 1;
        if (sides[i] == 0)
            points.emplace_back(corners[i]);
        if (sides[i] * sides[j] < 0)
            points.push_back(lineThroughPlane(corners[i], corners[j], plane));
    }
    return points;
}

/// Returns an axis along which the common line of both planes is not a point.
int axisAlong(const Corners& s, const Corners& t)
{
    using Wide = Eigen::Matrix<std::int64_t, 3, 1>;
    const auto normal = [](const Corners& c) {
        return Wide(Wide((c[1] - c[0]).cast<std::int64_t>()).cross(Wide((c[2] - c[0]).cast<std::int64_t>())));
    };
    const Wide m = normal(s), n = normal(t);
    for (int axis = 0; axis < 2; ++axis) {
        const auto [i, j] = Projection(axis);
        if (__int128(m[i]) * n[j] != __int128(m[j]) * n[i])
            return axis;
    }
    return 2;
}

/// A segment, from its first to its last point along an axis.
using Segment = std::pair<ExactPoint, ExactPoint>;

Segment ordered(const std::vector<ExactPoint>& points, int axis)
{
    const auto isLess = [axis](const ExactPoint& a, const ExactPoint& b) { return compare(a, b, axis) < 0; };
    const auto [first, last] = std::ranges::minmax_element(points, isLess);
    return {*first, *last};
}

std::optional<Segment> crossing(const Corners& s, const std::array<int, 3>& sidesOfS, const Corners& t,
                                const std::array<int, 3>& sidesOfT)
{
    const std::vector<ExactPoint> ofS = borderOn(s, sidesOfS, t), ofT = borderOn(t, sidesOfT, s);
    if (ofS.empty() || ofT.empty())
        return std::nullopt;
    const int axis = axisAlong(s, t);
    const Segment onS = ordered(ofS, axis), onT = ordered(ofT, axis);
    const ExactPoint& from = compare(onS.first, onT.first, axis) < 0 ? onT.first : onS.first;
    const ExactPoint& to = compare(onS.second, onT.second, axis) < 0 ? onS.second : onT.second;
    if (compare(from, to, axis) > 0)
        return std::nullopt;
    return Segment(from, to);
}

/// A face in its plane, projected along an axis.
class Sheet
{
public:
    Sheet(const Corners& at, int axis)
        : onto(axis)
        , corners{ExactPoint(at[0]), ExactPoint(at[1]), ExactPoint(at[2])}
        , turn(LatticePredicates::orient2d(at[0], at[1], at[2], axis))
    {}

    /// Returns whether the point is inside the face or on its border.
    bool contains(const ExactPoint& p) const
    {
        for (std::size_t i = 0; i < 3; ++i)
            if (orient2d(corners[i], corners[i == 2 ? 0 : i + 1], p, onto) * turn < 0)
                return false;
        return true;
    }
    /// Returns the part of the segment that is inside the face.
    std::optional<Segment> clip(const ExactPoint& a, const ExactPoint& b) const
    {
        std::vector<ExactPoint> points;
        for (const ExactPoint* end : {&a, &b})
            if (contains(*end))
                points.push_back(*end);
        for (std::size_t i = 0; i < 3; ++i) {
            const ExactPoint &c = corners[i], &d = corners[i == 2 ? 0 : i + 1];
            const int atC = orient2d(a, b, c, onto), atD = orient2d(a, b, d, onto);
            const int atA = orient2d(c, d, a, onto), atB = orient2d(c, d, b, onto);
            if (atC * atD < 0 && atA * atB < 0)
                points.push_back(linesCrossing(a, b, c, d, onto));
            else if (atC == 0 && isBetween(c, a, b, onto))
                points.push_back(c);
        }
        if (points.empty())
            return std::nullopt;
        return ordered(points, compare(a, b, onto.i) != 0 ? onto.i : onto.j);
    }
    /// Returns whether p is between a and b. Precondition: p is on the line ab.
    static bool isBetween(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b, Projection onto)
    {
        const int axis = compare(a, b, onto.i) != 0 ? onto.i : onto.j;
        return compare(a, p, axis) * compare(p, b, axis) >= 0;
    }

    Projection onto;
    std::array<ExactPoint, 3> corners;
    int turn; ///< 1: counter-clockwise in the projection; -1: clockwise
};

class FaceCutter
{
public:
    FaceCutter(const TriangleSoup& surface, Slot face)
        : m_surface(surface)
        , m_face(face)
        , m_corners(cornersOf(surface, face))
        , m_plane(planeOf(m_corners))
        , m_sheet(m_corners, m_plane.projectionAxis())
    {
        for (const ExactPoint& corner : m_sheet.corners)
            m_result.points.add(corner);
    }

    FacePieces cut(std::span<const Slot> others)
    {
        for (const Slot other : others)
            addLines(other);
        addCrossings();
        triangulate();
        return std::move(m_result);
    }

private:
    using Ends = std::pair<Slot, Slot>;

    void addLines(Slot other)
    {
        const Corners corners = cornersOf(m_surface, other);
        const std::array<int, 3> sides = sidesOf(corners, m_plane);
        if (sides != std::array<int, 3>{}) {
            if (const auto segment = crossing(m_corners, sidesOf(m_corners, planeOf(corners)), corners, sides))
                add(*segment);
            return;
        }
        const Sheet sheet(corners, m_plane.projectionAxis());
        for (std::size_t i = 0; i < 3; ++i)
            if (const auto segment = m_sheet.clip(sheet.corners[i], sheet.corners[i == 2 ? 0 : i + 1]))
                add(*segment);
        m_upon.emplace_back(other, sheet);
    }

    void add(const Segment& segment)
    {
        const Slot from = m_result.points.add(segment.first), to = m_result.points.add(segment.second);
        if (from != to)
            m_segments.insert(std::minmax(from, to));
    }

    int side(Slot a, Slot b, Slot c) const
    {
        return orient2d(m_result.points[a], m_result.points[b], m_result.points[c], m_sheet.onto);
    }

    void addCrossings()
    {
        for (auto s = m_segments.begin(); s != m_segments.end(); ++s) {
            for (auto t = std::next(s); t != m_segments.end(); ++t) {
                const auto [a, b] = *s;
                const auto [c, d] = *t;
                if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) {
                    const ExactPoints& p = m_result.points;
                    m_result.points.add(linesCrossing(p[a], p[b], p[c], p[d], m_sheet.onto));
                }
            }
        }
    }

    /// Returns the segment's parts between all points that are on it.
    std::vector<Ends> partsOf(const Ends& segment) const
    {
        const ExactPoints& p = m_result.points;
        const auto [a, b] = segment;
        const int axis = compare(p[a], p[b], m_sheet.onto.i) != 0 ? m_sheet.onto.i : m_sheet.onto.j;
        std::vector<Slot> on;
        for (Slot i = 0; i < p.size(); ++i)
            if (i == a || i == b || (side(a, b, i) == 0 && Sheet::isBetween(p[i], p[a], p[b], m_sheet.onto)))
                on.push_back(i);
        std::ranges::sort(on, [&](Slot i, Slot j) { return compare(p[i], p[j], axis) < 0; });
        std::vector<Ends> parts;
        for (std::size_t i = 1; i < on.size(); ++i)
            parts.emplace_back(std::minmax(on[i - 1], on[i]));
        return parts;
    }

    void triangulate()
    {
        const bool turned = m_sheet.turn < 0;
        PlanarTriangulation cells(m_result.points, turned ? Triangle{0, 2, 1} : Triangle{0, 1, 2}, m_sheet.onto);
        for (Slot i = 3; i < m_result.points.size(); ++i)
            cells.insert(i);
        std::set<Ends> forced;
        for (const Ends& segment : m_segments)
            for (const Ends& part : partsOf(segment))
                if (forced.insert(part).second)
                    cells.force(part.first, part.second);
        cells.improve();
        for (const Triangle& t : cells.triangles())
            addPiece(turned ? Triangle{t[0], t[2], t[1]} : t);
        for (const auto& [other, sheet] : m_upon)
            m_result.upon.push_back(other);
    }

    void addPiece(const Triangle& t)
    {
        FacePiece piece{t, 1};
        if (!m_upon.empty()) {
            const ExactPoints& p = m_result.points;
            const ExactPoint middle = centroid(p[t[0]], p[t[1]], p[t[2]]);
            for (const auto& [other, sheet] : m_upon) {
                if (!sheet.contains(middle))
                    continue;
                if (other < m_face)
                    return;
                piece.jump += sheet.turn == m_sheet.turn ? 1 : -1;
            }
        }
        if (piece.jump != 0)
            m_result.pieces.push_back(piece);
    }

    const TriangleSoup& m_surface;
    Slot m_face;
    Corners m_corners;
    Plane m_plane;
    Sheet m_sheet;
    std::set<Ends> m_segments;
    std::vector<std::pair<Slot, Sheet>> m_upon; ///< faces of the same plane that overlap this one
    FacePieces m_result;
};
} // namespace

FacePieces cutFace(const TriangleSoup& surface, Slot face, std::span<const Slot> others)
{
    return FaceCutter(surface, face).cut(others);
}
} // namespace core::repair
