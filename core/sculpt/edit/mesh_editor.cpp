#include "core/sculpt/edit/mesh_editor.h"

namespace core
{
/// Runs an operation, verified if the editor verifies. Returns false if it was refused or rolled back.
template <class Operation> bool MeshEditor::run(Operation operation)
{
    if (!m_tryOperation)
        return operation();
    bool done = false;
    return m_tryOperation([&] { done = operation(); }) && done;
}

/// Returns whether a corner of one of the edge's two faces is frozen.
bool MeshEditor::isFrozenAround(Slot e) const
{
    return m_frozen && (isFrozen(m_mesh.to(2 * e)) || isFrozen(m_mesh.to(2 * e + 1)) ||
                        isFrozen(m_mesh.to(m_mesh.next(2 * e))) || isFrozen(m_mesh.to(m_mesh.next(2 * e + 1))));
}

Vec3f MeshEditor::middle(Slot e) const
{
    const Vec3 sum = m_mesh.point(m_mesh.to(2 * e)).cast<double>() + m_mesh.point(m_mesh.to(2 * e + 1)).cast<double>();
    return m_mesh.lattice().snap(0.5 * sum);
}

// --- split

Slot MeshEditor::split(Slot e, const Vec3f& p)
{
    Slot m = noSlot;
    const bool done = run([&] {
        m = m_mirror ? splitPair(e, p) : m_mesh.splitEdge(e, p);
        return m != noSlot;
    });
    return done ? m : noSlot;
}

Slot MeshEditor::splitPair(Slot e, const Vec3f& p)
{
    if (m_mirror->isAcross(e))
        return splitOnPlane(e, p);
    splitEdgesAcross(m_mesh.face(2 * e));
    splitEdgesAcross(m_mesh.face(2 * e + 1));
    const Slot image = m_mirror->imageOfHalfedge(2 * e);
    if (image == noSlot)
        return noSlot;
    if (image / 2 == e)
        return splitOnPlane(e, p);
    const Vec3f kept = m_mirror->kept(p, false);
    const Slot m = m_mesh.splitEdge(e, kept);
    m_mirror->pair(m, m_mesh.splitEdge(image / 2, m_mirror->imageOf(kept)));
    return m;
}

/// Splits an edge that is in the mirror plane or crosses it. The new vertex is on the plane and is its own image.
Slot MeshEditor::splitOnPlane(Slot e, const Vec3f& p)
{
    return m_mesh.splitEdge(e, m_mirror->kept(p, true));
}

/// Splits the edge of face f that crosses the mirror plane, if there is one. Such a face is its own image, and its two
/// other edges are each other's images. Splitting those two would leave an edge without an image; splitting the
/// crossing edge first divides the face along the plane.
void MeshEditor::splitEdgesAcross(Slot f)
{
    const Slot first = m_mesh.faceHalfedge(f);
    for (Slot h : {first, m_mesh.next(first), m_mesh.prev(first)}) {
        if (m_mirror->isAcross(h / 2)) {
            splitOnPlane(h / 2, middle(h / 2));
            return;
        }
    }
}

// --- collapse

Slot MeshEditor::collapsing(Slot e) const
{
    return m_mirror && m_mirror->isOnPlane(m_mesh.from(2 * e)) ? 2 * e + 1 : 2 * e;
}

bool MeshEditor::collapse(Slot h, const Vec3f& p)
{
    if (isFrozenAround(h / 2))
        return false;
    return run([&] {
        if (m_mirror)
            return collapsePair(h, p);
        m_mesh.collapse(h, p);
        return true;
    });
}

bool MeshEditor::collapsePair(Slot h, const Vec3f& p)
{
    const Slot image = m_mirror->imageOfHalfedge(h);
    if (image == noSlot || m_mirror->isAcross(h / 2))
        return false;
    const Mesh::Mark mark = m_mesh.mark();
    m_mesh.collapse(h, p);
    if (image == h)
        return true;
    if (!m_mesh.isCollapseOk(image)) {
        m_mesh.rollback(mark);
        return false;
    }
    m_mesh.collapse(image, m_mirror->imageOf(p));
    return true;
}

// --- flip

bool MeshEditor::flip(Slot e)
{
    if (isFrozenAround(e))
        return false;
    return run([&] {
        if (m_mirror)
            return flipPair(e);
        m_mesh.flip(e);
        return true;
    });
}

bool MeshEditor::flipPair(Slot e)
{
    const Slot c = m_mesh.to(m_mesh.next(2 * e)), d = m_mesh.to(m_mesh.next(2 * e + 1));
    const Slot image = m_mirror->imageOfHalfedge(2 * e);
    if (image == noSlot || image / 2 == e || (m_mirror->isOnPlane(c) && m_mirror->isOnPlane(d)))
        return false;
    const Mesh::Mark mark = m_mesh.mark();
    m_mesh.flip(e);
    if (!m_mesh.isFlipOk(image / 2)) {
        m_mesh.rollback(mark);
        return false;
    }
    m_mesh.flip(image / 2);
    return true;
}

// --- move

bool MeshEditor::move(Slot v, const Vec3f& p)
{
    if (isFrozen(v))
        return false;
    return run([&] {
        if (m_mirror)
            return movePair(v, p);
        m_mesh.setPoint(v, p);
        return true;
    });
}

bool MeshEditor::movePair(Slot v, const Vec3f& p)
{
    const Slot image = m_mirror->imageOf(v);
    if (image == noSlot)
        return false;
    m_mesh.setPoint(v, p);
    if (image != v)
        m_mesh.setPoint(image, m_mirror->imageOf(p));
    return true;
}
} // namespace core
