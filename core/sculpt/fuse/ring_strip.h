#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace core
{
/// The vertices around another vertex, or a part of them, in order.
using Ring = std::vector<Slot>;

/// Returns the part of the ring from ring[first] to ring[last], past the end if necessary; the whole ring if first
/// equals last.
Ring arc(const Ring& ring, std::size_t first, std::size_t last);

/// The rule by which a strip of triangles advances along its two sides.
enum class Stepping {
    Even, ///< Bresenham's error diffusion (paper, section 3.4, Figure 13)
    /// advances so that the new edge across is the shorter one (Christiansen and Sederberg 1978); for sides that are
    /// close together and have uneven edges
    Nearest
};

/// Connects two polylines of the same direction by a strip of triangles. If their ends coincide, the first and the last
/// triangle close the strip there.
class RingStrip
{
public:
    RingStrip(const Ring& a, const Ring& b, std::vector<Triangle>& faces) : m_a(a), m_b(b), m_faces(faces) {}
    /// Makes a strip with Stepping::Nearest, by the vertices' positions in the mesh.
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
    const Mesh* m_mesh = nullptr; ///< null: each ring advances at an even rate (Stepping::Even)
};
} // namespace core
