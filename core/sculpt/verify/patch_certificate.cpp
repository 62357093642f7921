#include "core/sculpt/verify/patch_certificate.h"

#include "core/util/parallel.h"

#include <algorithm>
#include <atomic>

namespace core
{
namespace
{
using Vector = IntegerDirection;
constexpr double largestComponent = 1023;
constexpr std::size_t certifiedPerChunk = 1024;

// Overflow bounds: lattice differences are at most 2^24, so a cross product's component is at most 2^49. Times a
// direction component of 2^10, summed over three terms: below 2^61.

Vector difference(const LatticePoint& a, const LatticePoint& b)
{
    return (a - b).cast<std::int64_t>();
}

/// Returns the sign of the area of the triangle pqr in the projection along the direction.
int projectedOrientation(const Vector& direction, const LatticePoint& p, const LatticePoint& q, const LatticePoint& r)
{
    const std::int64_t area = direction.dot(difference(q, p).cross(difference(r, p)));
    return (area > 0) - (area < 0);
}

/// Sorts the edges in their order along the loop. Returns false if they do not form one loop through distinct vertices.
bool orderLoop(std::vector<BoundaryEdge>& boundary)
{
    if (boundary.size() < 3)
        return false;
    std::ranges::sort(boundary, {}, &BoundaryEdge::from);
    for (std::size_t i = 1; i < boundary.size(); ++i) {
        if (boundary[i].from == boundary[i - 1].from)
            return false;
    }
    std::vector<BoundaryEdge> loop;
    loop.reserve(boundary.size());
    Slot at = boundary.front().from;
    do {
        const auto next = std::ranges::lower_bound(boundary, at, {}, &BoundaryEdge::from);
        if (next == boundary.end() || next->from != at)
            return false;
        loop.push_back(*next);
        at = next->to;
    } while (at != boundary.front().from && loop.size() < boundary.size());
    const bool closed = at == boundary.front().from && loop.size() == boundary.size();
    boundary.swap(loop);
    return closed;
}

/// An edge's extent in two coordinates of the projection plane, for the sweep in isSimple().
struct Extent
{
    std::int64_t minX, maxX, minY, maxY;
    std::size_t index; ///< the edge's position along the loop
};

bool segmentsMeet(const Vector& direction, const BoundaryEdge& s, const BoundaryEdge& t)
{
    const int a = projectedOrientation(direction, s.fromPoint, s.toPoint, t.fromPoint);
    const int b = projectedOrientation(direction, s.fromPoint, s.toPoint, t.toPoint);
    const int c = projectedOrientation(direction, t.fromPoint, t.toPoint, s.fromPoint);
    const int d = projectedOrientation(direction, t.fromPoint, t.toPoint, s.toPoint);
    // the caller has checked that the extents overlap, so touching and collinear segments count as meeting
    return a * b <= 0 && c * d <= 0;
}

/// Returns whether the edge t overlaps its predecessor s on the loop: t runs straight back.
bool runsBack(const Vector& direction, const BoundaryEdge& s, const BoundaryEdge& t)
{
    if (projectedOrientation(direction, s.fromPoint, s.toPoint, t.toPoint) != 0)
        return false;
    const Vector along = difference(s.toPoint, s.fromPoint), on = difference(t.toPoint, t.fromPoint);
    // Compares the perpendiculars of the edges in the projection plane, direction x along and direction x on. Doubles
    // suffice, because the dot product of two collinear vectors is near zero only if one of them is.
    const Eigen::Vector3d u = direction.cross(along).cast<double>(), w = direction.cross(on).cast<double>();
    return u.dot(w) <= 0;
}

bool isSimple(const std::vector<BoundaryEdge>& loop, const Vector& direction)
{
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    // Projects onto two coordinates that are constant along the direction. They are integers of magnitude up to 2^34,
    // so exact.
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const auto coordinate = [&](const LatticePoint& p, int k) {
        return direction[axis] * p[k] - direction[k] * static_cast<std::int64_t>(p[axis]);
    };
    const std::size_t n = loop.size();
    std::vector<Extent> extents(n);
    for (std::size_t e = 0; e < n; ++e) {
        const auto [x0, x1] = std::minmax({coordinate(loop[e].fromPoint, i), coordinate(loop[e].toPoint, i)});
        const auto [y0, y1] = std::minmax({coordinate(loop[e].fromPoint, j), coordinate(loop[e].toPoint, j)});
        extents[e] = {x0, x1, y0, y1, e};
        if (runsBack(direction, loop[e], loop[(e + 1) % n]))
            return false;
    }
    std::ranges::sort(extents, [](const Extent& a, const Extent& b) { return a.minX < b.minX; });
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n && extents[b].minX <= extents[a].maxX; ++b) {
            if (extents[b].minY > extents[a].maxY || extents[a].minY > extents[b].maxY)
                continue;
            const std::size_t apart = (extents[a].index + n - extents[b].index) % n;
            if (apart != 1 && apart != n - 1 && segmentsMeet(direction, loop[extents[a].index], loop[extents[b].index]))
                return false;
        }
    }
    return true;
}
} // namespace

IntegerDirection integerDirection(const Vec3& v)
{
    const double largest = v.cwiseAbs().maxCoeff();
    if (!(largest > 0))
        return IntegerDirection::Zero();
    const Vec3 scaled = v * (largestComponent / largest);
    return {std::llrint(scaled.x()), std::llrint(scaled.y()), std::llrint(scaled.z())};
}

bool certifyPatch(std::span<const PatchFace> faces, std::vector<BoundaryEdge>& boundary,
                  const IntegerDirection& direction)
{
    return arePositive(faces, direction) && isSimpleLoop(boundary, direction);
}

bool arePositive(std::span<const PatchFace> faces, const IntegerDirection& direction)
{
    std::atomic<bool> positive = true;
    forEachChunk(faces.size(), certifiedPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (const PatchFace& f : faces.subspan(begin, end - begin)) {
            if (projectedOrientation(direction, f.points[0], f.points[1], f.points[2]) <= 0) {
                positive = false;
                return;
            }
        }
    });
    return positive;
}

bool isSimpleLoop(std::vector<BoundaryEdge>& boundary, const IntegerDirection& direction)
{
    return orderLoop(boundary) && isSimple(boundary, direction);
}

bool certifyStar(const Mesh& mesh, Slot v)
{
    const LatticePoint p = mesh.latticePoint(v);
    std::array<Vector, 16> spokes;
    std::size_t n = 0;
    bool fits = true;
    mesh.forEachOutgoing(v, [&](Slot h) {
        if (n == spokes.size())
            fits = false;
        else
            spokes[n++] = difference(mesh.latticePoint(mesh.to(h)), p);
    });
    if (!fits)
        return false;
    Vector sum = Vector::Zero();
    std::array<Vector, 16> normals;
    for (std::size_t i = 0; i < n; ++i) {
        normals[i] = spokes[i].cross(spokes[(i + 1) % n]);
        sum += normals[i];
    }
    const Vector direction = integerDirection(sum.cast<double>());
    for (std::size_t i = 0; i < n; ++i) {
        if (direction.dot(normals[i]) <= 0)
            return false;
    }
    // The faces go around once if no later sector contains the first spoke. Each sector is less than half a turn, since
    // its face is positive.
    for (std::size_t i = 1; i < n; ++i) {
        const std::int64_t before = direction.dot(spokes[i].cross(spokes[0]));
        const std::int64_t after = direction.dot(spokes[0].cross(spokes[(i + 1) % n]));
        if (before >= 0 && after > 0)
            return false;
    }
    return true;
}
} // namespace core
