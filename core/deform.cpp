#include "deform.h"

namespace core
{
namespace
{
/// At strength 1 the peak of Pull and Push is this part of the radius.
constexpr double peakPerRadius = 0.1;

Vec3 neighbourMean(const Mesh& mesh, Slot v)
{
    Vec3 sum = Vec3::Zero();
    int n = 0;
    // Sums of lattice coordinates are exact in a double, so their order does not matter.
    mesh.forEachOutgoing(v, [&](Slot h) {
        sum += mesh.point(mesh.to(h)).cast<double>();
        ++n;
    });
    return sum / n;
}
} // namespace

Vec3 vertexNormal(const Mesh& mesh, Slot v)
{
    using Vector = Eigen::Matrix<std::int64_t, 3, 1>;
    const LatticePoint p = mesh.latticePoint(v);
    Vector sum = Vector::Zero();
    const Slot first = mesh.outgoing(v);
    Vector spoke = (mesh.latticePoint(mesh.to(first)) - p).cast<std::int64_t>();
    Slot h = first;
    do {
        h = mesh.rotate(h);
        const Vector next = (mesh.latticePoint(mesh.to(h)) - p).cast<std::int64_t>();
        sum += spoke.cross(next);
        spoke = next;
    } while (h != first);
    return sum.cast<double>();
}

double planDeformation(Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab)
{
    const double sign = settings.tool == Tool::Push ? -1 : 1;
    const double amount = settings.tool == Tool::Smooth ? std::min(dab.strength, 1.0)
                                                        : sign * peakPerRadius * dab.radius * dab.strength;
    double longest2 = 0;
    region.forEach([&](Slot v) {
        const Vec3 p = mesh.point(v).cast<double>();
        const double x = std::min((p - dab.position).norm() / dab.radius, 1.0);
        const double weight = amount * falloff(x, settings.falloff);
        Vec3 direction = Vec3::Zero();
        if (settings.tool == Tool::Smooth) {
            direction = neighbourMean(mesh, v) - p;
        } else {
            const Vec3 normal = vertexNormal(mesh, v);
            const double length = normal.norm();
            if (length > 0)
                direction = normal / length;
        }
        const Vec3 plan = weight * direction;
        region.setPlan(v, plan);
        longest2 = std::max(longest2, plan.squaredNorm());
    });
    return std::sqrt(longest2);
}
} // namespace core
