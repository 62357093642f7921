// Decides whether two triangles meet outside their shared corners and edges. By the number of shared corners:
//   3  the same triangle: yes
//   2  only if coplanar with both apexes on one side of the shared edge (folded over)
//   1  only if one triangle's edge opposite the shared corner meets the other triangle
//   0  Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation predicates", 2003;
//      coplanar triangles by separating edges

#include "core/geometry/triangle_intersection.h"

#include <cassert>
#include <utility>

namespace core
{
namespace
{
template <typename Predicates> using Points = std::array<typename Predicates::Point, 3>;

/// The corners of two triangles, reordered so that shared corners come first, in the same order in both triangles.
/// Reordering may reverse the winding; nothing in this file depends on the winding.
template <typename Predicates> struct AlignedPair
{
    Points<Predicates> s, t;
    int shared;
};

template <typename Predicates>
AlignedPair<Predicates> align(const CornerTriangle<Predicates>& s, const CornerTriangle<Predicates>& t)
{
    int shared = 0;
    std::array<std::size_t, 3> si{0, 1, 2}, ti{0, 1, 2};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = static_cast<std::size_t>(shared); j < 3; ++j) {
            if (s.ids[i] == t.ids[ti[j]]) {
                std::swap(ti[static_cast<std::size_t>(shared)], ti[j]);
                std::swap(si[static_cast<std::size_t>(shared)], si[i]);
                ++shared;
                break;
            }
        }
    }
    return {{s.points[si[0]], s.points[si[1]], s.points[si[2]]},
            {t.points[ti[0]], t.points[ti[1]], t.points[ti[2]]},
            shared};
}

/// Precondition: s and t share the edge of their first two corners.
template <typename Predicates> bool intersectBesideEdge(const Points<Predicates>& s, const Points<Predicates>& t)
{
    const typename Predicates::Plane plane(s[0], s[1], s[2]);
    if (plane.side(t[2]) != 0)
        return false;
    const int axis = plane.projectionAxis();
    return Predicates::orient2d(s[0], s[1], s[2], axis) == Predicates::orient2d(t[0], t[1], t[2], axis);
}

/// Returns whether the angles of two coplanar triangles at their shared first corner overlap, even in a single ray.
template <typename Predicates> bool anglesOverlap(Points<Predicates> s, Points<Predicates> t, int axis)
{
    for (Points<Predicates>* corners : {&s, &t})
        if (Predicates::orient2d((*corners)[0], (*corners)[1], (*corners)[2], axis) < 0)
            std::swap((*corners)[1], (*corners)[2]);
    const auto inAngle = [axis](const Points<Predicates>& a, const typename Predicates::Point& p) {
        return Predicates::orient2d(a[0], a[1], p, axis) >= 0 && Predicates::orient2d(a[0], p, a[2], axis) >= 0;
    };
    return inAngle(s, t[1]) || inAngle(t, s[1]); // the common part begins at one of these two rays
}

/// Precondition: s = vpq and t = vru share only their first corner v. An edge that crosses the plane of the other
/// triangle meets that triangle if its line passes all three sides in the same sense. Four of the six orientations
/// follow from the sides of the planes.
template <typename Predicates> bool intersectBesideCorner(const Points<Predicates>& s, const Points<Predicates>& t)
{
    const typename Predicates::Plane tPlane(t[0], t[1], t[2]);
    const int p = tPlane.side(s[1]), q = tPlane.side(s[2]);
    if (p * q > 0)
        return false;
    const typename Predicates::Plane sPlane(s[0], s[1], s[2]);
    if (p == 0 && q == 0)
        return anglesOverlap<Predicates>(s, t, sPlane.projectionAxis());
    const int r = sPlane.side(t[1]), u = sPlane.side(t[2]);
    if (r * u > 0)
        return false;
    const int across = Predicates::orient3d(s[1], s[2], t[1], t[2]);
    const auto oneSense = [across](int first, int last) {
        return (first >= 0 && across >= 0 && last <= 0) || (first <= 0 && across <= 0 && last >= 0);
    };
    return oneSense(r, u) || oneSense(p, q);
}

/// Returns whether all corners of t are strictly outside one edge of s. Precondition: s winds counter-clockwise in the
/// projection.
template <typename Predicates> bool edgeSeparates(const Points<Predicates>& s, const Points<Predicates>& t, int axis)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = s[i];
        const auto& b = s[i == 2 ? 0 : i + 1];
        if (Predicates::orient2d(a, b, t[0], axis) < 0 && Predicates::orient2d(a, b, t[1], axis) < 0 &&
            Predicates::orient2d(a, b, t[2], axis) < 0)
            return true;
    }
    return false;
}

template <typename Predicates> bool coplanarIntersect(Points<Predicates> s, Points<Predicates> t, int axis)
{
    for (Points<Predicates>* corners : {&s, &t})
        if (Predicates::orient2d((*corners)[0], (*corners)[1], (*corners)[2], axis) < 0)
            std::swap((*corners)[1], (*corners)[2]);
    return !edgeSeparates<Predicates>(s, t, axis) && !edgeSeparates<Predicates>(t, s, axis);
}

/// The corner of a triangle that is alone on its closed side of a plane, and whether that side is the positive one.
struct LoneCorner
{
    std::size_t index;
    bool positive;
};

/// Precondition: `sides` are neither all 0 nor all strictly of one sign.
LoneCorner loneCorner(const std::array<int, 3>& sides)
{
    const auto count = [&sides](int side) { return (sides[0] == side) + (sides[1] == side) + (sides[2] == side); };
    const auto find = [&sides](int side) -> std::size_t { return sides[0] == side ? 0 : sides[1] == side ? 1 : 2; };
    if (count(1) == 1)
        return {find(1), true};
    if (count(-1) == 1)
        return {find(-1), false};
    return {find(0), count(-1) == 2};
}

template <typename Predicates> Points<Predicates> turned(const Points<Predicates>& points, std::size_t first)
{
    return {points[first], points[(first + 1) % 3], points[(first + 2) % 3]};
}

template <typename Predicates>
std::array<int, 3> sidesOf(const typename Predicates::Plane& plane, const Points<Predicates>& points)
{
    return {plane.side(points[0]), plane.side(points[1]), plane.side(points[2])};
}

bool allStrictlyOneSide(const std::array<int, 3>& sides)
{
    return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

/// Precondition: the triangles share no corner.
template <typename Predicates> bool intersectApart(const Points<Predicates>& s, const Points<Predicates>& t)
{
    const typename Predicates::Plane tPlane(t[0], t[1], t[2]);
    const std::array<int, 3> sSides = sidesOf<Predicates>(tPlane, s);
    if (allStrictlyOneSide(sSides))
        return false;
    const typename Predicates::Plane sPlane(s[0], s[1], s[2]);
    if (sSides == std::array{0, 0, 0})
        return coplanarIntersect<Predicates>(s, t, sPlane.projectionAxis());
    const std::array<int, 3> tSides = sidesOf<Predicates>(sPlane, t);
    if (allStrictlyOneSide(tSides))
        return false;

    // Each triangle cuts the common line of the planes in an interval that ends on the two edges at its lone corner. If
    // both lone corners are on positive sides, two orientations decide whether the intervals overlap.
    const LoneCorner sLone = loneCorner(sSides), tLone = loneCorner(tSides);
    Points<Predicates> a = turned<Predicates>(s, sLone.index), b = turned<Predicates>(t, tLone.index);
    if (!sLone.positive)
        std::swap(b[1], b[2]);
    if (!tLone.positive)
        std::swap(a[1], a[2]);
    return Predicates::orient3d(a[0], a[1], b[0], b[1]) <= 0 && Predicates::orient3d(a[0], a[2], b[2], b[0]) <= 0;
}
} // namespace

template <typename Predicates>
bool trianglesIntersect(const CornerTriangle<Predicates>& s, const CornerTriangle<Predicates>& t)
{
    assert(!Predicates::collinear(s.points[0], s.points[1], s.points[2]));
    assert(!Predicates::collinear(t.points[0], t.points[1], t.points[2]));
    const AlignedPair<Predicates> pair = align(s, t);
    switch (pair.shared) {
    case 0:
        return intersectApart<Predicates>(pair.s, pair.t);
    case 1:
        return intersectBesideCorner<Predicates>(pair.s, pair.t);
    case 2:
        return intersectBesideEdge<Predicates>(pair.s, pair.t);
    default:
        return true;
    }
}

template bool trianglesIntersect(const CornerTriangle<LatticePredicates>&, const CornerTriangle<LatticePredicates>&);
template bool trianglesIntersect(const CornerTriangle<FloatPredicates>&, const CornerTriangle<FloatPredicates>&);
} // namespace core
