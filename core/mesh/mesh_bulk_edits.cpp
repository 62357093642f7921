// Edits of the whole mesh. Cost: O(mesh), except setFrame().

#include "core/mesh/mesh.h"

#include <algorithm>

namespace core
{
void Mesh::relocate(const Lattice& lattice, std::span<const Vec3f> points)
{
    assert(m_strokeOpen);
    m_frame.lattice = lattice;
    for (const Slot v : vertices()) {
        if (points[v] != point(v))
            setPoint(v, points[v]);
    }
}

void Mesh::reverseOrientation(std::optional<PartId> part)
{
    const auto isMeant = [&](Slot v) { return !part || this->part(v) == *part; };
    for (const Slot e : edges()) {
        const Slot a = to(2 * e), b = to(2 * e + 1);
        if (!isMeant(a))
            continue;
        setTo(2 * e, b);
        setTo(2 * e + 1, a);
    }
    for (const Slot v : vertices()) {
        if (isMeant(v))
            setOutgoing(v, outgoing(v) ^ 1);
    }
    for (const Slot f : faces()) {
        if (!isMeant(m_corners[f][0]))
            continue;
        const Slot h0 = faceHalfedge(f), h1 = next(h0), h2 = next(h1);
        link(f, h0, h2, h1);
    }
}

void Mesh::assign(const Mesh& other)
{
    assert(m_strokeOpen);
    const SlotCounts here = slots(), there = other.slots();
    resize({std::max(here.vertices, there.vertices), std::max(here.edges, there.edges),
            std::max(here.faces, there.faces)});
    for (Slot f = 0; f < m_faceSlots.size(); ++f)
        assignFace(other, f);
    for (Slot e = 0; e < m_edgeSlots.size(); ++e)
        assignEdge(other, e);
    for (Slot v = 0; v < m_vertexSlots.size(); ++v)
        assignVertex(other, v);
    resize(there);
    m_frame = other.m_frame;
}

void Mesh::assignVertex(const Mesh& other, Slot v)
{
    const bool wasThere = isVertex(v);
    if (v >= other.m_vertexSlots.size() || !other.isVertex(v)) {
        if (wasThere)
            freeVertex(v);
        return;
    }
    if (wasThere && point(v) == other.point(v) && color(v) == other.color(v) && mask(v) == other.mask(v) &&
        m_parts[v] == other.m_parts[v] && outgoing(v) == other.outgoing(v))
        return;
    touchVertex(v);
    m_vertexSlots.setFree(v, false);
    m_kernel.set_point(vertexHandle(v), other.point(v));
    m_kernel.set_color(vertexHandle(v), other.m_kernel.color(vertexHandle(v)));
    m_parts[v] = other.m_parts[v];
    m_kernel.vertex(vertexHandle(v)) = other.m_kernel.vertex(vertexHandle(v));
}

void Mesh::assignEdge(const Mesh& other, Slot e)
{
    const bool wasThere = isEdge(e);
    if (e >= other.m_edgeSlots.size() || !other.isEdge(e)) {
        if (wasThere)
            freeEdge(e);
        return;
    }
    const auto isAlike = [&](Slot h) {
        return to(h) == other.to(h) && next(h) == other.next(h) && prev(h) == other.prev(h) && face(h) == other.face(h);
    };
    if (wasThere && isAlike(2 * e) && isAlike(2 * e + 1))
        return;
    touchEdge(e);
    m_edgeSlots.setFree(e, false);
    m_kernel.edge(edgeHandle(e)) = other.m_kernel.edge(edgeHandle(e));
}

void Mesh::assignFace(const Mesh& other, Slot f)
{
    const bool wasThere = isFace(f);
    if (f >= other.m_faceSlots.size() || !other.isFace(f)) {
        if (wasThere)
            freeFace(f);
        return;
    }
    if (wasThere && corners(f) == other.corners(f) && faceHalfedge(f) == other.faceHalfedge(f))
        return;
    touchFace(f);
    m_faceSlots.setFree(f, false);
    m_corners[f] = other.m_corners[f];
    m_kernel.face(faceHandle(f)) = other.m_kernel.face(faceHandle(f));
}

void Mesh::setFrame(const MeshFrame& frame)
{
    assert(m_strokeOpen && frame.lattice == m_frame.lattice);
    m_frame = frame;
}
} // namespace core
