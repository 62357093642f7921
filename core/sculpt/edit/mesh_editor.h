#pragma once

#include "core/sculpt/edit/mirror_map.h"
#include "core/util/slot_set.h"

#include <functional>

namespace core
{
/// Runs one operation; false means that it was verified and rolled back.
using TryOperation = std::function<bool(const std::function<void()>& operation)>;

/// How remeshing and deformation write: each operation may be verified, and with a mirror each is done together with
/// its mirror image or not at all. In a mirror only the half where the coordinate is not negative is named, the plane
/// included; then these hold: a vertex on the plane stays on it and another off it, by at least one lattice unit; an
/// edge on the plane is never flipped and collapses along it; an edge that ends on the plane collapses onto it.
class MeshEditor
{
public:
    /// `tryOperation`: empty if operations are not verified. `mirror`: null, or on. `frozen`: null, or vertices at
    /// which nothing moves, collapses or flips, so that the faces around them keep their shape, too.
    explicit MeshEditor(Mesh& mesh, TryOperation tryOperation = {}, MirrorMap* mirror = nullptr,
                        const SlotSet* frozen = nullptr)
        : m_mesh(mesh)
        , m_tryOperation(std::move(tryOperation))
        , m_mirror(mirror)
        , m_frozen(frozen)
    {}

    const Mesh& mesh() const { return m_mesh; }
    MirrorMap* mirror() { return m_mirror; }

    /// Whether the editor may be asked to change the face: any without a mirror, one of the half with it.
    bool names(Slot f) const { return !m_mirror || m_mirror->isInHalf(m_mesh.corners(f)); }
    /// Returns the place nearest to p, on the lattice, that v may have.
    Vec3f kept(Slot v, const Vec3f& p) const
    {
        if (m_mesh.freedom(v) == 0)
            return m_mesh.point(v);
        return m_mirror ? m_mirror->kept(p, m_mirror->isOnPlane(v)) : p;
    }

    /// Puts a vertex into the middle of an edge. Returns it, or noSlot if it was rolled back.
    Slot split(Slot e) { return split(e, middle(e)); }
    /// Puts a vertex at p, a place on the edge and on the lattice, into it.
    Slot split(Slot e, const Vec3f& p);

    /// Returns the middle of the edge, on the lattice.
    Vec3f middle(Slot e) const;
    /// Returns the half-edge whose start is to be merged into its end. If just one end is on the mirror's plane, it
    /// stays.
    Slot collapsing(Slot e) const;
    /// Merges from(h) into to(h), which moves to p. Preconditions: h is collapsing(), Mesh::isCollapseOk(h), p is
    /// kept(to(h), p). False if it was refused or rolled back.
    bool collapse(Slot h, const Vec3f& p);
    /// Precondition: Mesh::isFlipOk. False if it was refused or rolled back.
    bool flip(Slot e);
    /// Precondition: p is kept(v, p). False if it was refused or rolled back.
    bool move(Slot v, const Vec3f& p);

private:
    template <class Operation> bool run(Operation operation);
    bool isFrozen(Slot v) const { return m_frozen && m_frozen->contains(v); }
    bool isFrozenAround(Slot e) const;
    Slot splitPair(Slot e, const Vec3f& p);
    void splitEdgesAcross(Slot f);
    Slot splitOnPlane(Slot e, const Vec3f& p);
    bool collapsePair(Slot h, const Vec3f& p);
    bool flipPair(Slot e);
    bool movePair(Slot v, const Vec3f& p);

    Mesh& m_mesh;
    TryOperation m_tryOperation;
    MirrorMap* m_mirror;
    const SlotSet* m_frozen;
};
} // namespace core
