// Edits of the whole mesh, O(mesh).

#include "mesh.h"

namespace core
{
void Mesh::relocate(const Lattice& lattice, std::span<const Vec3f> points)
{
    assert(m_strokeOpen);
    m_frame.lattice = lattice;
    for (Slot v = 0; v < m_vertexSlots.size(); ++v) {
        if (isVertex(v) && points[v] != point(v))
            setPoint(v, points[v]);
    }
}

void Mesh::turnOver()
{
    for (Slot e = 0; e < m_edgeSlots.size(); ++e) {
        if (!isEdge(e))
            continue;
        const Slot a = to(2 * e), b = to(2 * e + 1);
        setTo(2 * e, b);
        setTo(2 * e + 1, a);
    }
    for (Slot v = 0; v < m_vertexSlots.size(); ++v) {
        if (isVertex(v))
            setOutgoing(v, outgoing(v) ^ 1);
    }
    for (Slot f = 0; f < m_faceSlots.size(); ++f) {
        if (!isFace(f))
            continue;
        const Slot h0 = faceHalfedge(f), h1 = next(h0), h2 = next(h1);
        link(f, h0, h2, h1);
    }
}

void Mesh::setUniformDetail(double length)
{
    assert(m_strokeOpen);
    m_frame.uniformDetail = length;
}
} // namespace core
