#pragma once

#include "core/sculpt/select/region.h"

namespace core
{
/// Selects the vertices under a brush (paper, section 3.1). Keeps references to the mesh and its octree. Precondition:
/// the octree is up to date.
class Selector
{
public:
    Selector(const Mesh& mesh, const FaceOctree& octree) : m_mesh(mesh), m_octree(octree) {}

    /// Selects the vertices within the ball. A spherical brush uses the Euclidean distance from the ball's centre; a
    /// ray brush uses the geodesic distance from the surface point nearest to the centre. `candidates` receives the
    /// candidate triangles. `max`: see selectGeodesic().
    void select(Region& region, std::vector<Slot>& candidates, BrushShape brush, const Sphere& ball,
                Slot max = noSlot) const;

    /// Selects with a ray brush after refine() has changed the mesh around `refined.remeshed()`. `candidates`: the
    /// candidate triangles from before the refinement. `selected` and `refined` may be the same region.
    void selectRefined(Region& selected, Region& refined, std::vector<Slot> candidates, const Sphere& ball) const;

    /// Removes all vertices from the region except those on the part of the surface in the ball that is nearest to its
    /// centre. A part is a set of faces that meet the ball and are connected by edges.
    void keepNearestPart(Region& region, const Sphere& ball) const;

    /// Returns the faces whose boxes meet the ball's box, in ascending order.
    std::vector<Slot> facesIn(const Sphere& ball) const;

private:
    const Mesh& m_mesh;
    const FaceOctree& m_octree;
};
} // namespace core
