#include "core/analysis/winding_number.h"

#include "core/analysis/angle_sum.h"
#include "core/geometry/face_geometry.h"
#include "core/util/radix_sort.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>

namespace core
{
namespace
{
struct Border
{
    Slot from, to;
};

/// Returns the directed edges along which faces run more often in this direction, once for each time.
std::vector<Border> bordersOf(std::span<const Triangle> triangles)
{
    constexpr int slotBits = 32;
    std::vector<std::uint64_t> up, down; // edges by the way in which a face runs along them: lower end, higher end
    up.reserve(2 * triangles.size());
    down.reserve(2 * triangles.size());
    const auto add = [&](std::uint64_t from, std::uint64_t to) {
        from < to ? up.push_back(from << slotBits | to) : down.push_back(to << slotBits | from);
    };
    for (const auto& [a, b, c] : triangles) {
        add(a, b);
        add(b, c);
        add(c, a);
    }
    radixSort(up);
    radixSort(down);
    std::vector<std::uint64_t> more;
    std::vector<Border> borders;
    std::ranges::set_difference(up, down, std::back_inserter(more));
    for (const std::uint64_t edge : more)
        borders.push_back({static_cast<Slot>(edge >> slotBits), static_cast<Slot>(edge)});
    more.clear();
    std::ranges::set_difference(down, up, std::back_inserter(more));
    for (const std::uint64_t edge : more)
        borders.push_back({static_cast<Slot>(edge), static_cast<Slot>(edge >> slotBits)});
    return borders;
}

/// Seen against an axis: returns 1 if the edge from a to b crosses, upwards, the half-line to the right of p; -1 if it
/// crosses it downwards; 0 if not. Exactly opposite for the opposite edge.
int turnOf(const Vec3& a, const Vec3& b, const Vec3& p, int axis)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool runsUp = b[v] > p[v];
    if ((a[v] > p[v]) == runsUp)
        return 0;
    const Vec3 &low = runsUp ? a : b, &high = runsUp ? b : a;
    const bool isRight = (high[u] - low[u]) * (p[v] - low[v]) >= (high[v] - low[v]) * (p[u] - low[u]);
    return !isRight ? 0 : runsUp ? 1 : -1;
}

/// Returns how often the triangle's outline runs around p, seen against the axis: 1, 0 or -1.
int turnsOf(const std::array<Vec3, 3>& triangle, const Vec3& p, int axis)
{
    const auto& [a, b, c] = triangle;
    return turnOf(a, b, p, axis) + turnOf(b, c, p, axis) + turnOf(c, a, p, axis);
}

/// Returns 1 or -1 if the ray from p along the axis leaves or enters the space behind the triangle, otherwise 0.
int crossingOf(const std::array<Vec3, 3>& triangle, const Vec3& p, int axis)
{
    const int turns = turnsOf(triangle, p, axis);
    if (turns == 0)
        return 0;
    // Where rounding alone puts the ray into an upright triangle, its determinant says nothing; its outline does.
    const int v = (axis + 2) % 3;
    bool isAbove = false, isBeneath = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
        if ((a[v] > p[v]) == (b[v] > p[v]))
            continue;
        const double height = a[axis] + (b[axis] - a[axis]) * ((p[v] - a[v]) / (b[v] - a[v]));
        (height > p[axis] ? isAbove : isBeneath) = true;
    }
    if (isAbove != isBeneath)
        return isAbove ? turns : 0;
    const auto& [a, b, c] = triangle;
    const bool isBehind = (a - p).dot((b - p).cross(c - p)) >= 0;
    return isBehind == (turns > 0) ? turns : 0;
}

/// Returns the axis that is nearest to the triangle's normal.
int axisAcross(const std::array<Vec3, 3>& triangle)
{
    int axis = 0;
    (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// Adds half of the solid angle of the curtain that hangs from the edge against the axis; it runs along the edge from
/// its end to its start. The limit of the formula for triangles (Van Oosterom and Strackee 1983). Straight beneath the
/// edge, p is on the side where turnOf() takes it to be: a little to the left (-u), and even less above (+v).
void addHalfCurtain(const std::array<Vec3, 2>& edge, const Vec3& p, int axis, AngleSum& sum)
{
    constexpr double least = 1e-200; // stands for 0 on one side
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 a = edge[0] - p, b = edge[1] - p;
    const auto isOverhead = [&](const Vec3& end) { return end[u] == 0 && end[v] == 0 && end[axis] > 0; };
    const auto orLeast = [](double y, double side) { return y == 0 ? std::copysign(least, side) : y; };
    if (isOverhead(a) || isOverhead(b)) {
        if (!isOverhead(b))
            sum.add(b[u], orLeast(b[v], b[u]));
        else if (!isOverhead(a))
            sum.add(a[u], -orLeast(a[v], a[u]));
        return;
    }
    const auto depth = [&](const Vec3& end) { // length minus height
        const double length = end.norm(), height = end[axis];
        return height > 0 ? (end[u] * end[u] + end[v] * end[v]) / (length + height) : length - height;
    };
    double y = a[u] * b[v] - a[v] * b[u];
    if ((a[v] > 0) != (b[v] > 0)) {
        const bool isRight = turnOf(edge[0], edge[1], p, axis) != 0, runsUp = b[v] > 0;
        y = std::copysign(std::max(std::abs(y), least), isRight == runsUp ? 1 : -1);
    } else {
        y = orLeast(y, b[u] - a[u]);
    }
    sum.add(depth(a) * depth(b) + a[u] * b[u] + a[v] * b[v], y);
}

std::vector<Vec3> placesOf(const TriangleMesh& mesh)
{
    std::vector<Vec3> places;
    places.reserve(mesh.points.size());
    for (const Vec3f& p : mesh.points)
        places.push_back(p.cast<double>());
    return places;
}
} // namespace

WindingNumber::WindingNumber(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    constexpr std::size_t maxBorders = 512; // each query visits all of them
    if (triangles.empty())
        return;
    const std::vector<Border> borders = bordersOf(triangles);
    if (borders.size() > std::min(maxBorders, triangles.size())) {
        m_angles.emplace(points, triangles);
        return;
    }
    m_tree.emplace(faceBoxes(points, triangles));
    m_triangles.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
        m_triangles.push_back({points[a], points[b], points[c]});
    for (const auto& [from, to] : borders)
        m_borders.push_back({points[from], points[to]});
}

WindingNumber::WindingNumber(const TriangleMesh& mesh) : WindingNumber(placesOf(mesh), mesh.triangles) {}

double WindingNumber::at(const Vec3& p, std::span<const Slot> without) const
{
    if (m_angles)
        return m_angles->at(p, without);
    if (!m_tree)
        return 0;
    const int axis = without.empty() ? 2 : axisAcross(m_triangles[without[0]]);
    return crossingsAt(p, axis, without) - curtainsAt(p, axis);
}

double WindingNumber::crossingsAt(const Vec3& p, int axis, std::span<const Slot> without) const
{
    constexpr double half = 0.5;
    FaceBox ray;
    ray.extend(p.array().cast<float>());
    ray.max[axis] = std::numeric_limits<float>::infinity();
    int turns = 0;
    m_tree->forEachMeeting(ray, [&](Slot position) {
        const Slot face = m_tree->at(position);
        if (!std::ranges::binary_search(without, face))
            turns += crossingOf(m_triangles[face], p, axis);
    });
    int beside = 0; // p is between the two sides of the faces that it lies on, so they count half
    for (const Slot face : without)
        beside += turnsOf(m_triangles[face], p, axis);
    return turns + half * beside;
}

double WindingNumber::curtainsAt(const Vec3& p, int axis) const
{
    AngleSum half;
    for (const std::array<Vec3, 2>& edge : m_borders)
        addHalfCurtain(edge, p, axis, half);
    return half.value() / (2 * std::numbers::pi);
}
} // namespace core
