#pragma once

#include "geometry.h"

#include <vector>

namespace core
{
/// Vertices around another, or a part of them, in order.
using Ring = std::vector<Slot>;

/// From ring[first] to ring[last], around the end if need be; the whole ring if they are the same.
Ring arc(const Ring& ring, std::size_t first, std::size_t last);

/// Connects two polylines that run the same way by a strip of triangles, in Bresenham's error diffusion (paper, section 3.4,
/// Figure 13). With common ends the first and the last triangle close the gap there.
class Zip
{
public:
    Zip(const Ring& a, const Ring& b, std::vector<Triangle>& faces) : m_a(a), m_b(b), m_faces(faces) {}

    void open() { diffuse(0, 0, m_a.size() - 1, m_b.size() - 1); }
    void betweenCommonEnds();

private:
    void diffuse(std::size_t i, std::size_t j, std::size_t n, std::size_t m);

    const Ring& m_a;
    const Ring& m_b;
    std::vector<Triangle>& m_faces;
};
} // namespace core
