#include "core/operations/transform_region.h"

#include <cmath>

namespace core
{
namespace
{
/// The middle of the edges across which the freedom changes, weighted by the change and the length.
class Border
{
public:
    void add(const Mesh& mesh, Slot from, Slot to)
    {
        const Vec3 a = mesh.point(from).cast<double>(), b = mesh.point(to).cast<double>();
        const double weight = std::abs(mesh.freedom(from) - mesh.freedom(to)) * (b - a).norm();
        m_sum += weight / 2 * (a + b);
        m_weight += weight;
    }
    std::optional<Vec3> middle() const { return m_weight > 0 ? std::optional(Vec3(m_sum / m_weight)) : std::nullopt; }

private:
    Vec3 m_sum = Vec3::Zero();
    double m_weight = 0;
};
} // namespace

TransformRegion transformRegionOf(const Mesh& mesh, std::optional<PartId> part)
{
    constexpr std::uint8_t whole = 255;
    TransformRegion region;
    auto vertices = std::make_shared<Footprint>(), all = std::make_shared<Footprint>();
    Border border;
    for (const Slot v : mesh.vertices()) {
        if (part && mesh.part(v) != *part)
            continue;
        region.whole.extend(mesh.point(v).cast<double>());
        all->slots.push_back(v);
        const double freedom = mesh.freedom(v);
        if (freedom == 0)
            continue;
        vertices->slots.push_back(v);
        vertices->weights.push_back(static_cast<std::uint8_t>(std::lround(whole * freedom)));
        region.box.extend(mesh.point(v).cast<double>());
        mesh.forEachOutgoing(v, [&](Slot h) { border.add(mesh, v, mesh.to(h)); });
    }
    region.centre = border.middle().value_or(region.box.isEmpty() ? Vec3::Zero() : Vec3(region.box.center()));
    if (const Part* const own = part ? mesh.frame().parts.find(*part) : nullptr)
        region.axes = own->axes;
    region.vertices = std::move(vertices);
    all->weights.assign(all->slots.size(), whole);
    region.all = std::move(all);
    return region;
}
} // namespace core
