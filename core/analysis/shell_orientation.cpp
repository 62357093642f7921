#include "core/analysis/shell_orientation.h"

#include "core/geometry/predicates.h"

namespace core
{
void ShellOrientation::addFace(const Points& points)
{
    using Vector = Eigen::Matrix<std::int64_t, 3, 1>;
    // |coordinate| <= 2^23: a component of the cross product is at most 2^47, the dot product 2^72.
    const Vector a = points[0].cast<std::int64_t>();
    const Vector n = points[1].cast<std::int64_t>().cross(points[2].cast<std::int64_t>());
    for (int i = 0; i < 3; ++i)
        m_sixVolumes += static_cast<Int128>(a[i]) * n[i];
    for (const LatticePoint& p : points) { // the highest vertex has the fewest faces above it
        if (std::tie(m_origin.z(), m_origin.x(), m_origin.y()) < std::tie(p.z(), p.x(), p.y()))
            m_origin = p;
    }
}

LatticeBox ShellOrientation::column() const
{
    return {m_origin, {m_origin.x(), m_origin.y(), Lattice::limit}};
}

/// The ray goes up (+z) from the origin. The origin is treated as if moved by (e, e^2, 0) for a tiny e > 0, so that the
/// ray meets no edge.
void ShellOrientation::castAt(const Points& points)
{
    bool inside = false;
    for (int i = 0; i < 3; ++i) {
        const LatticePoint& a = points[static_cast<std::size_t>(i)];
        const LatticePoint& b = points[static_cast<std::size_t>((i + 1) % 3)];
        if ((a.y() > m_origin.y()) == (b.y() > m_origin.y()))
            continue;
        // The edge crosses the horizontal line y = origin.y. The crossing is right of the origin if the origin is left
        // of the rising edge.
        const LatticePoint& low = a.y() > b.y() ? b : a;
        const LatticePoint& high = a.y() > b.y() ? a : b;
        if (LatticePredicates::orient2d(low, high, m_origin, 2) > 0)
            inside = !inside;
    }
    if (!inside)
        return;
    const int facing = LatticePredicates::orient2d(points[0], points[1], points[2], 2);
    const int side = LatticePredicates::orient3d(points[0], points[1], points[2], m_origin);
    if (facing * side < 0)
        m_odd = !m_odd;
}
} // namespace core
