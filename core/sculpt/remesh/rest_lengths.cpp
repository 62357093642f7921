#include "core/sculpt/remesh/rest_lengths.h"

#include "core/sculpt/remesh/remesh.h"

#include <algorithm>

namespace core
{
void RestLengths::clear()
{
    m_vertices.clear();
    m_lengths.clear();
    m_sharp.clear();
}

void RestLengths::measure(const Region& region, const Mesh& mesh)
{
    region.forEach([&](Slot v) {
        if (m_vertices.contains(v))
            return;
        const Vec3f p = mesh.point(v);
        float shortest2 = std::numeric_limits<float>::infinity();
        mesh.forEachOutgoing(
            v, [&](Slot h) { shortest2 = std::min(shortest2, (mesh.point(mesh.to(h)) - p).squaredNorm()); });
        set(v, std::sqrt(shortest2), isSharp(mesh, v));
    });
}

void RestLengths::set(Slot v, double length, bool isSharp)
{
    const Slot i = m_vertices.add(v);
    m_lengths.resize(m_vertices.size());
    m_lengths[i] = length;
    m_sharp.resize(m_vertices.size());
    m_sharp[i] = isSharp;
}
} // namespace core
