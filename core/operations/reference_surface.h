#pragma once

#include "core/mesh/face_octree.h"
#include "core/stroke/tool.h"

#include <optional>

namespace core
{
/// A copy of the surface before a remeshing, which finds the places of the new mesh's vertices on it.
class ReferenceSurface
{
public:
    explicit ReferenceSurface(const Mesh& mesh);

    /// Returns the place half way to the mean of v's neighbours, projected back onto the surface. At a crease of the
    /// new mesh, v moves along the crease and is projected onto both sides; at a corner it is projected onto all sides.
    /// Never projects onto another sheet than v's own.
    Vec3 evenPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v) const;
    /// Returns a place slightly off the surface, so that the edges around v are on it on average. Otherwise the edges
    /// of a round shape are inside it, and volume is lost. Vertices at creases and corners stay.
    Vec3 raisedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v) const;

private:
    struct Reach
    {
        double distance;
        Vec3 way; ///< normal that found faces must roughly have, of any length
    };
    /// Returns the point nearest to p, within reach.distance, on a face with a normal like reach.way. If several are
    /// equally near, returns the one on the face with the lowest slot. Returns nothing if there is none.
    std::optional<Vec3> nearest(const Vec3& p, const Reach& reach) const;
    std::optional<Vec3> nearestWithin(const Vec3& p, const Reach& reach) const;

    Mesh m_mesh;
    FaceOctree m_octree;
    std::vector<LatticeBox> m_boxes; ///< by face slot
};
} // namespace core
