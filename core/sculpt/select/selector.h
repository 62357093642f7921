#pragma once

#include "core/sculpt/select/region.h"

namespace core
{
/// Selects the vertices under a brush (paper, section 3.1). Refers to the mesh and its octree, which is up to date.
class Selector
{
public:
    Selector(const Mesh& mesh, const FaceOctree& octree) : m_mesh(mesh), m_octree(octree) {}

    /// Selects the vertices within the ball: by Euclidean distance from its centre with a spherical brush, by geodesic
    /// distance from the nearest point of the surface with a ray brush. `candidates` becomes the candidate triangles.
    /// `max`: as in selectGeodesic().
    void select(Region& region, std::vector<Slot>& candidates, BrushShape brush, const Sphere& ball,
                Slot max = noSlot) const;

    /// Selects with a ray brush on a mesh that refine() has changed around `refined.remeshed()`. `candidates`: the
    /// candidate triangles from before. `selected` and `refined` may be the same region.
    void selectRefined(Region& selected, Region& refined, std::vector<Slot> candidates, const Sphere& ball) const;

    /// Leaves only the region's vertices on the part of the surface within the ball that is nearest to its centre: what
    /// hangs together by faces that meet the ball.
    void keepNearestPart(Region& region, const Sphere& ball) const;

    /// Returns the faces whose boxes meet the ball's, ascending.
    std::vector<Slot> facesIn(const Sphere& ball) const;

private:
    const Mesh& m_mesh;
    const FaceOctree& m_octree;
};
} // namespace core
