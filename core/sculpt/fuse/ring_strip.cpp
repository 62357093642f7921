#include "core/sculpt/fuse/ring_strip.h"

namespace core
{
Ring arc(const Ring& ring, std::size_t first, std::size_t last)
{
    Ring part = {ring[first]};
    for (std::size_t i = (first + 1) % ring.size();; i = (i + 1) % ring.size()) {
        part.push_back(ring[i]);
        if (i == last)
            return part;
    }
}

void RingStrip::betweenCommonEnds()
{
    const std::size_t n = m_a.size() - 1, m = m_b.size() - 1;
    if (n == 1 && m == 1)
        return; // a single edge, where the removed stars leave no gap
    if (n == 1) {
        for (std::size_t j = 1; j < m; ++j)
            m_faces.push_back({m_b[j + 1], m_b[j], m_a[0]});
    } else if (m == 1) {
        for (std::size_t i = 1; i < n; ++i)
            m_faces.push_back({m_a[i], m_a[i + 1], m_a[0]});
    } else {
        m_faces.push_back({m_a[0], m_a[1], m_b[1]});
        step(1, 1, n - 1, m - 1);
        m_faces.push_back({m_a[n - 1], m_a[n], m_b[m - 1]});
    }
}

/// Makes the strip from (i, j) to (n, m). With Stepping::Even, the side advances that has covered the smaller share of
/// its length.
void RingStrip::step(std::size_t i, std::size_t j, std::size_t n, std::size_t m)
{
    const std::size_t i0 = i, j0 = j;
    const auto aGoesOn = [&] { return m_mesh ? isNearer(i, j) : (i + 1 - i0) * (m - j0) <= (j + 1 - j0) * (n - i0); };
    while (i < n || j < m) {
        if (j == m || (i < n && aGoesOn())) {
            m_faces.push_back({m_a[i], m_a[i + 1], m_b[j]});
            ++i;
        } else {
            m_faces.push_back({m_b[j + 1], m_b[j], m_a[i]});
            ++j;
        }
    }
}

/// Returns whether a's next vertex is nearer to b's current vertex than b's next vertex is to a's current one.
bool RingStrip::isNearer(std::size_t i, std::size_t j) const
{
    const auto distance2 = [&](Slot v, Slot w) {
        return (m_mesh->point(v).cast<double>() - m_mesh->point(w).cast<double>()).squaredNorm();
    };
    return distance2(m_a[i + 1], m_b[j]) <= distance2(m_b[j + 1], m_a[i]);
}
} // namespace core
