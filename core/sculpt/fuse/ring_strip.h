#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace core
{
/// Vertices around another, or a part of them, in order.
using Ring = std::vector<Slot>;

/// From ring[first] to ring[last], around the end if need be; the whole ring if they are the same.
Ring arc(const Ring& ring, std::size_t first, std::size_t last);

/// In which order a strip goes on along its two sides.
enum class Stepping {
    Even, ///< Bresenham's error diffusion (paper, section 3.4, Figure 13)
    /// By the shorter of the two edges across (Christiansen and Sederberg 1978): for sides that lie close, with uneven
    /// edges.
    Nearest
};

/// Connects two polylines that run the same way by a strip of triangles. With common ends the first and the last
/// triangle close the gap there.
class RingStrip
{
public:
    RingStrip(const Ring& a, const Ring& b, std::vector<Triangle>& faces) : m_a(a), m_b(b), m_faces(faces) {}
    /// Stepping::Nearest, by where the mesh has the vertices.
    RingStrip(const Ring& a, const Ring& b, std::vector<Triangle>& faces, const Mesh& mesh)
        : m_a(a)
        , m_b(b)
        , m_faces(faces)
        , m_mesh(&mesh)
    {}

    void open() { step(0, 0, m_a.size() - 1, m_b.size() - 1); }
    void betweenCommonEnds();

private:
    void step(std::size_t i, std::size_t j, std::size_t n, std::size_t m);
    bool isNearer(std::size_t i, std::size_t j) const;

    const Ring& m_a;
    const Ring& m_b;
    std::vector<Triangle>& m_faces;
    const Mesh* m_mesh = nullptr; ///< null: each ring takes its steps at an even rate
};
} // namespace core
