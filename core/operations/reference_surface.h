#pragma once

#include "core/mesh/face_octree.h"
#include "core/stroke/tool.h"

#include <optional>

namespace core
{
/// The surface as it was before a remeshing, and where the vertices of the new one belong on it. A copy of the mesh.
class ReferenceSurface
{
public:
    explicit ReferenceSurface(const Mesh& mesh);

    /// Half way towards the mean of v's neighbours and back onto the surface; at a crease of the new mesh along the
    /// crease and onto both of its sides, at a corner onto all. Never on another sheet than v's own.
    Vec3 evenPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v) const;
    /// Beside the surface, so that the edges around v lie on it in the mean: else those of a round shape lie inside it,
    /// and volume is lost. At creases and corners v stays.
    Vec3 raisedPlace(const Mesh& mesh, const EdgeBounds& bounds, Slot v) const;

private:
    struct Reach
    {
        double distance;
        Vec3 way; ///< of any length
    };
    /// The nearest point within reach on a face that looks that way; of several the one on the lowest face.
    std::optional<Vec3> nearest(const Vec3& p, const Reach& reach) const;
    std::optional<Vec3> nearestWithin(const Vec3& p, const Reach& reach) const;

    Mesh m_mesh;
    FaceOctree m_octree;
    std::vector<LatticeBox> m_boxes; ///< by face
};
} // namespace core
