#pragma once

#include "core/mesh/face_octree.h"
#include "core/stroke/stroke.h"
#include "core/stroke/tool.h"
#include "core/util/sparse_index.h"

namespace core
{
/// Finds the mirror image of each vertex of a surface about x, y or z = 0. Geometry alone decides which vertex is the
/// image of which: the negative of a lattice coordinate is exact, and no two vertices of a sound mesh share a point. So
/// the mesh stores nothing of it, and undo knows nothing of it. Not thread-safe: remembers what it found.
class MirrorMap
{
public:
    explicit MirrorMap(const Mesh& mesh) : m_mesh(mesh) {}

    /// Forgets all images.
    void setPlane(Symmetry plane);
    bool isOn() const { return m_axis >= 0; }

    // --- all of the following only while it is on
    template <class Vector> Vector imageOf(Vector p) const
    {
        p[m_axis] = 0 - p[m_axis]; // never -0
        return p;
    }
    /// Returns the point or its image, whichever has a coordinate that is not negative.
    template <class Vector> Vector folded(const Vector& p) const { return p[m_axis] < 0 ? imageOf(p) : p; }

    /// Returns the dab as seen in the mirror: it turns the other way, too.
    Dab imageOf(Dab dab) const;

    /// Returns the signed distance from the plane, in mm.
    float height(const Vec3f& p) const { return p[m_axis]; }
    float height(Slot v) const { return height(m_mesh.point(v)); }
    bool isOnPlane(Slot v) const { return height(v) == 0; }
    bool isInHalf(Slot v) const { return height(v) >= 0; }
    /// Whether the ends of the edge are each other's image.
    bool isAcross(Slot e) const;
    bool isInHalf(const Triangle& corners) const;

    /// Returns the vertex whose point is the image of v's; v itself on the plane. It is found if it was learnt, or is
    /// next to a neighbour's image; else noSlot.
    Slot imageOf(Slot v);
    /// Returns the half-edge that runs from the image of h's start to that of its end, or noSlot: h itself on the
    /// plane, h^1 across it.
    Slot imageOfHalfedge(Slot h);
    /// Returns noSlot if it has none.
    Slot imageOfFace(Slot f);
    void pair(Slot v, Slot image);

    /// Whether each of these faces has an image, face for face and bit for bit, and as masked. Learns the images of
    /// their corners. Precondition: the octree is up to date. Cost: the faces.
    bool learn(std::span<const Slot> faces, const FaceOctree& octree);

    /// Returns the place nearest to p that is allowed: a vertex on the plane stays on it, another stays at least one
    /// lattice unit off it, on its side.
    Vec3f kept(Vec3f p, bool onPlane) const;

private:
    Slot known(Slot v) const;
    Slot nextToNeighbour(Slot v) const;
    bool learnFace(Slot f, const FaceOctree& octree);
    bool lookUp(Slot v, const FaceOctree& octree);

    const Mesh& m_mesh;
    int m_axis = -1;
    SparseIndex m_vertices;     ///< learnt
    std::vector<Slot> m_images; ///< by position in m_vertices; may be out of date, so each use compares points
    SlotSet m_faces;            ///< learnt
    SlotSet m_wanted;           ///< faces to learn
};
} // namespace core
