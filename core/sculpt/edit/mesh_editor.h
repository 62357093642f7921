#pragma once

#include "core/sculpt/edit/mirror_map.h"
#include "core/util/slot_set.h"

#include <functional>

namespace core
{
/// Runs one operation and verifies it. Returns false if it did not verify and was rolled back.
using TryOperation = std::function<bool(const std::function<void()>& operation)>;

/// The interface through which remeshing and deformation change the mesh. Each operation may be verified. With a
/// mirror, each operation is done together with its mirror image, or not at all.
/// With a mirror, callers refer only to vertices, edges and faces on its positive side (coordinate >= 0, plane
/// included). The editor then guarantees: a vertex on the plane stays on it; a vertex off the plane stays off it by at
/// least one lattice unit; an edge in the plane is never flipped and collapses within the plane; an edge with one end
/// on the plane collapses onto that end.
class MeshEditor
{
public:
    /// `tryOperation`: empty if operations are not verified. `mirror`: null, or a map that is on. `frozen`: null, or
    /// vertices that must not move and whose faces must not be collapsed or flipped.
    explicit MeshEditor(Mesh& mesh, TryOperation tryOperation = {}, MirrorMap* mirror = nullptr,
                        const SlotSet* frozen = nullptr)
        : m_mesh(mesh)
        , m_tryOperation(std::move(tryOperation))
        , m_mirror(mirror)
        , m_frozen(frozen)
    {}

    const Mesh& mesh() const { return m_mesh; }
    MirrorMap* mirror() { return m_mirror; }

    /// Returns whether callers may refer to the face: always without a mirror; with one, only if the face is on its
    /// positive side.
    bool names(Slot f) const { return !m_mirror || m_mirror->isInHalf(m_mesh.corners(f)); }
    /// Returns the lattice point nearest to p that v may move to. A fully masked vertex keeps its point; a mirror keeps
    /// v on or off its plane.
    Vec3f kept(Slot v, const Vec3f& p) const
    {
        if (m_mesh.freedom(v) == 0)
            return m_mesh.point(v);
        return m_mirror ? m_mirror->kept(p, m_mirror->isOnPlane(v)) : p;
    }

    /// Splits an edge in its middle. Returns the new vertex, or noSlot if the split was rolled back.
    Slot split(Slot e) { return split(e, middle(e)); }
    /// Splits an edge at p, a lattice point on the edge. Returns the new vertex, or noSlot if the split was rolled
    /// back.
    Slot split(Slot e, const Vec3f& p);

    /// Returns the middle of the edge, rounded to the lattice.
    Vec3f middle(Slot e) const;
    /// Returns the half-edge of e whose start is to be merged into its end. If exactly one end is on the mirror's
    /// plane, that end remains.
    Slot collapsing(Slot e) const;
    /// Merges from(h) into to(h), which moves to p. Preconditions: h is collapsing(e) of its edge,
    /// Mesh::isCollapseOk(h), and p equals kept(to(h), p). Returns false if the collapse was refused or rolled back.
    bool collapse(Slot h, const Vec3f& p);
    /// Flips an edge. Precondition: Mesh::isFlipOk(e). Returns false if the flip was refused or rolled back.
    bool flip(Slot e);
    /// Moves a vertex. Precondition: p equals kept(v, p). Returns false if the move was refused or rolled back.
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
