#include "core/sculpt/deform/grab_push.h"

#include "core/mesh/mesh.h"
#include "core/sculpt/deform/deform.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// Factor of the distance from the hand: the hand pushes within two thirds of the brush's radius.
constexpr double handFactor = 1.5;
} // namespace

GrabPush::GrabPush(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab,
                   const Vec3& moved)
    : m_center(dab.position)
    , m_moved(moved)
    , m_step(dab.radius / steps)
{
    if (settings.falloff == 0) // without falloff, a vertex is held whole or not at all
        return;
    for (std::size_t i = 0; i <= steps; ++i)
        m_weights[i] = weightAt(static_cast<double>(i) * m_step, settings, dab);
    findHeld(region, mesh);
}

double GrabPush::at(const Vec3& place, double weight) const
{
    const Vec3 p = place - m_center;
    const double along = p.dot(m_moved), way2 = m_moved.squaredNorm(), p2 = p.squaredNorm();
    if (along <= weight * way2) // behind the ball of its weight, and so outside those of larger weights
        return weight;
    const auto outside = [&](std::size_t i) { // distance from ball i, mm; negative inside
        const double w = m_weights[i];
        return std::sqrt(std::max(p2 + w * (w * way2 - 2 * along), 0.0)) - static_cast<double>(i) * m_step;
    };
    double before = outside(0);
    const double least = std::max(weight, byHand(before));
    for (std::size_t i = 1; i <= steps && m_weights[i - 1] > least; ++i) {
        const double now = outside(i);
        if (now <= 0)
            return std::max(least, m_weights[i - 1] + before / (before - now) * (m_weights[i] - m_weights[i - 1]));
        before = now;
    }
    return least;
}

double GrabPush::byHand(double distance) const
{
    const double at = std::min(handFactor * distance / m_step, static_cast<double>(steps));
    const std::size_t i = std::min(static_cast<std::size_t>(at), steps - 1);
    return m_weights[i] + (at - static_cast<double>(i)) * (m_weights[i + 1] - m_weights[i]);
}

void GrabPush::findHeld(const Region& region, const Mesh& mesh)
{
    Slot nearest = noSlot;
    region.forEach([&](Slot v) {
        if (nearest == noSlot || region.distance(v) < region.distance(nearest))
            nearest = v;
    });
    if (nearest != noSlot)
        m_held.add(nearest);
    for (std::size_t i = 0; i < m_held.size(); ++i) { // the set grows during the loop
        mesh.forEachOutgoing(m_held.slots()[i], [&](Slot h) {
            if (region.contains(mesh.to(h)))
                m_held.add(mesh.to(h));
        });
    }
}
} // namespace core
