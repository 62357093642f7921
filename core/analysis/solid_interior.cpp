#include "core/analysis/solid_interior.h"

#include "core/geometry/face_geometry.h"

#include <cmath>
#include <limits>

namespace core
{
namespace
{
/// Returns whether the ray up from p meets the triangle. Two triangles compute the same for a common edge, so the ray
/// meets exactly one of them there, or both or neither where the surface turns back.
bool isAbove(const std::array<Vec3, 3>& triangle, const Vec3& p)
{
    bool isInside = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
        if ((a.y() > p.y()) == (b.y() > p.y()))
            continue;
        const Vec3 &low = a.y() > b.y() ? b : a, &high = a.y() > b.y() ? a : b;
        if ((high.x() - low.x()) * (p.y() - low.y()) < (high.y() - low.y()) * (p.x() - low.x()))
            continue;
        isInside = !isInside;
    }
    if (!isInside)
        return false;
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    return normal.z() * normal.dot(p - triangle[0]) < 0;
}
} // namespace

SolidInterior::SolidInterior(const TriangleMesh& solid)
    : m_tree(faceBoxes(solid.points, std::span<const Triangle>(solid.triangles)))
{
    m_triangles.reserve(m_tree.size());
    for (Slot i = 0; i < m_tree.size(); ++i) {
        const auto& [a, b, c] = solid.triangles[m_tree.at(i)];
        m_triangles.push_back(
            {solid.points[a].cast<double>(), solid.points[b].cast<double>(), solid.points[c].cast<double>()});
    }
}

bool SolidInterior::contains(const Vec3& p) const
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Eigen::Array3f at = p.array().cast<float>();
    FaceBox column; // contains the ray in spite of rounding
    for (int i = 0; i < 3; ++i) {
        column.min[i] = std::nextafter(at[i], -infinity);
        column.max[i] = i < 2 ? std::nextafter(at[i], infinity) : infinity;
    }
    bool isOdd = false;
    m_tree.forEachMeeting(column, [&](Slot i) { isOdd = isOdd != isAbove(m_triangles[i], p); });
    return isOdd;
}
} // namespace core
