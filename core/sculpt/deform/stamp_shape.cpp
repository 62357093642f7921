#include "core/sculpt/deform/stamp_shape.h"

#include "core/sculpt/deform/brush_model.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// Length of an icosahedron's edges, in radii of its circumscribed ball.
constexpr double firstEdge = 1.0515;

std::optional<BrushModel::Span> spanOfBall(const Vec3& p)
{
    if (p.squaredNorm() >= 1)
        return std::nullopt;
    const double top = std::sqrt(1 - p.x() * p.x() - p.z() * p.z());
    return BrushModel::Span{-top, top};
}
} // namespace

StampShape::StampShape(const DabFrame& frame, const StrokeSettings& settings, const Dab& dab)
    : m_frame(frame)
    , m_model(settings.model.get())
    , m_center(dab.position)
    , m_radius(dab.radius)
    , m_share(std::min(dab.strength, 1.0))
    , m_raises(settings.inverted)
{}

Vec3 StampShape::field(const Vec3& p, double reach) const
{
    const auto depthNear = [&](double right, double up) {
        return depthAt(p + reach * (right * m_frame.right + up * m_frame.up));
    };
    const double middle = depthNear(0, 0);
    if (reach == 0)
        return m_share * middle * m_frame.normal;
    int inside = 0;
    double sum = 0;
    for (const double right : {-0.75, 0.75})
        for (const double up : {-0.75, 0.75})
            inside += depthNear(right, up) != 0 ? 1 : 0;
    if (inside == (middle != 0 ? 4 : 0))
        return m_share * middle * m_frame.normal;
    for (const double right : {-0.75, -0.25, 0.25, 0.75})
        for (const double up : {-0.75, -0.25, 0.25, 0.75})
            sum += depthNear(right, up);
    return m_share * (sum / 16) * m_frame.normal;
}

TriangleMesh StampShape::solid(double edge, std::vector<Vec3>& places) const
{
    const double perEdge = std::max(1.0, firstEdge * m_radius / edge);
    const int subdivisions = std::clamp(static_cast<int>(std::ceil(std::log2(perEdge))), 2, 6);
    TriangleMesh solid = m_model ? m_model->surface() : icosphere(subdivisions, 1);
    for (const Vec3f& point : solid.points) {
        const Vec3 p = m_radius * point.cast<double>();
        places.push_back(m_center + p.x() * m_frame.right + m_share * p.y() * m_frame.normal - p.z() * m_frame.up);
    }
    if (m_frame.right.cross(m_frame.up).dot(m_frame.normal) < 0) {
        for (Triangle& t : solid.triangles)
            std::swap(t[1], t[2]);
    }
    return solid;
}

double StampShape::depthAt(const Vec3& p) const
{
    const Vec3 r = (p - m_center) / m_radius;
    const Vec3 at(r.dot(m_frame.right), r.dot(m_frame.normal), -r.dot(m_frame.up));
    const auto span = m_model ? m_model->spanAt(at) : spanOfBall(at);
    return span ? ((m_raises ? span->high : span->low) - at.y()) * m_radius : 0;
}
} // namespace core
