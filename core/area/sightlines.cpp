#include "core/area/sightlines.h"

#include <algorithm>
#include <utility>

namespace core
{
namespace
{
std::vector<FaceBox> boxesOf(std::span<const Vec3f> points, const std::vector<Triangle>& faces)
{
    std::vector<FaceBox> boxes(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const Slot v : faces[f])
            boxes[f].extend(points[v].array());
    return boxes;
}
} // namespace

Sightlines::Sightlines(std::span<const Vec3f> points, std::vector<Triangle> faces)
    : m_points(points)
    , m_faces(std::move(faces))
    , m_tree(boxesOf(points, m_faces))
{}

bool Sightlines::isMet(const FaceBox& box, const Vec3& p, const Vec3& way, double reach)
{
    double first = 0, last = reach;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = double(box.min[axis]) - p[axis], high = double(box.max[axis]) - p[axis];
        if (way[axis] == 0) {
            if (low > 0 || high < 0)
                return false;
            continue;
        }
        const auto [in, out] = std::minmax({low / way[axis], high / way[axis]});
        first = std::max(first, in);
        last = std::min(last, out);
    }
    return first <= last * (1 + 1e-12);
}

/// Tests the signs of the volumes that the line spans with the sides of the face (Segura and Feito 2001). Zero counts
/// as either sign, so that no line slips between two faces.
bool Sightlines::isMet(Slot face, const Vec3& p, const Vec3& way, double reach) const
{
    const auto& [i, j, k] = m_faces[face];
    const Vec3 a = m_points[i].cast<double>() - p, b = m_points[j].cast<double>() - p,
               c = m_points[k].cast<double>() - p;
    const double ab = way.dot(a.cross(b)), bc = way.dot(b.cross(c)), ca = way.dot(c.cross(a));
    if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)))
        return false;
    const double sum = ab + bc + ca; // 0: the line is in the face's plane
    if (sum == 0)
        return false;
    const double at = a.dot(b.cross(c)) / sum;
    return at > 0 && at < reach;
}
} // namespace core
