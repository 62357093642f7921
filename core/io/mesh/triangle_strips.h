#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace core::io
{
/// Makes triangles from strips. Each corner forms a triangle with the two before it; every second triangle is reversed,
/// so that all face the same side. Omits triangles that have a corner twice, which strips use to connect or turn.
class TriangleStrips
{
public:
    void restart() { m_corners = 0; }
    void add(Slot corner)
    {
        if (m_corners >= 2) {
            auto [a, b] = std::pair(m_beforeLast, m_last);
            if (m_corners % 2 != 0)
                std::swap(a, b);
            if (a != b && b != corner && corner != a)
                m_triangles.push_back({a, b, corner});
        }
        m_beforeLast = m_last;
        m_last = corner;
        ++m_corners;
    }

    const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
    std::vector<Triangle> m_triangles;
    std::size_t m_corners = 0; ///< number of corners of the strip so far
    Slot m_beforeLast = 0, m_last = 0;
};
} // namespace core::io
