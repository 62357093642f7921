#pragma once

#include "core/mesh/face_octree.h"
#include "core/stroke/stroke.h"
#include "core/stroke/tool.h"
#include "core/util/sparse_index.h"

namespace core
{
/// Finds the mirror image of each vertex of a surface about the plane x, y or z = 0. Geometry alone defines it:
/// negating a lattice coordinate is exact, and no two vertices of a sound mesh share a point. So the mesh stores no
/// pairing, and undo needs none. Caches the images found. Thread: not thread-safe.
class MirrorMap
{
public:
    explicit MirrorMap(const Mesh& mesh) : m_mesh(mesh) {}

    /// Sets the mirror plane and clears the cached images. Symmetry::None switches the map off.
    void setPlane(Symmetry plane);
    bool isOn() const { return m_axis >= 0; }

    // --- precondition of all following functions: isOn()
    template <class Vector> Vector imageOf(Vector p) const
    {
        p[m_axis] = 0 - p[m_axis]; // 0 - x is never -0, unlike -x
        return p;
    }
    /// Returns the point or its image, whichever is on the positive side.
    template <class Vector> Vector folded(const Vector& p) const { return p[m_axis] < 0 ? imageOf(p) : p; }

    /// Returns the point of the plane nearest to p, or the part of a vector in the plane.
    template <class Vector> Vector onPlane(Vector p) const
    {
        p[m_axis] = 0;
        return p;
    }
    /// Returns the plane's normal, a unit vector.
    Vec3 normal() const { return Vec3::Unit(m_axis); }

    /// Returns the dab's mirror image. Its turn is reversed, too.
    Dab imageOf(Dab dab) const;

    /// Returns the signed distance from the plane, in mm.
    float height(const Vec3f& p) const { return p[m_axis]; }
    double height(const Vec3& p) const { return p[m_axis]; }
    float height(Slot v) const { return height(m_mesh.point(v)); }
    bool isOnPlane(Slot v) const { return height(v) == 0; }
    bool isInHalf(Slot v) const { return height(v) >= 0; }
    /// Returns whether the edge crosses the plane: its ends are each other's images.
    bool isAcross(Slot e) const;
    bool isInHalf(const Triangle& corners) const;

    /// Returns the vertex at the mirror image of v's point; v itself on the plane. Returns noSlot unless the image is
    /// cached or is a neighbour of a neighbour's cached image.
    Slot imageOf(Slot v);
    /// Returns the half-edge from the image of h's start to the image of h's end, or noSlot. Returns h itself if h is
    /// in the plane, and h^1 if h crosses it.
    Slot imageOfHalfedge(Slot h);
    /// Returns the face whose corners are the images of f's, or noSlot.
    Slot imageOfFace(Slot f);
    void pair(Slot v, Slot image);

    /// Returns whether each of these faces has a mirror image: a face at exactly mirrored points with the same masks.
    /// Caches the images of their corners. Precondition: the octree is up to date. Cost: O(faces).
    bool learn(std::span<const Slot> faces, const FaceOctree& octree);

    /// Returns the allowed point nearest to p. A vertex on the plane must stay on it; any other vertex must stay on the
    /// positive side, at least one lattice unit off the plane.
    Vec3f kept(Vec3f p, bool onPlane) const;

private:
    Slot known(Slot v) const;
    Slot nextToNeighbour(Slot v) const;
    bool learnFace(Slot f, const FaceOctree& octree);
    bool lookUp(Slot v, const FaceOctree& octree);

    const Mesh& m_mesh;
    int m_axis = -1;
    SparseIndex m_vertices; ///< vertices whose images are cached
    /// images, by position in m_vertices; may be out of date, so each use compares the points
    std::vector<Slot> m_images;
    SlotSet m_faces;  ///< faces whose images are known, and these images
    SlotSet m_wanted; ///< faces passed to learn()
};
} // namespace core
