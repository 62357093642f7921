#pragma once

#include "core/mesh/surface_hit.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/util/sparse_index.h"

namespace core
{
/// How far a stroke has moved each vertex, in mm, rounded to the lattice. The tool Layer raises the surface to one
/// height by it, however often a stroke passes; and the dabs of a path over the surface stand on it as it was before.
class StrokeDisplacements
{
public:
    /// Returns whether strokes with these settings need it.
    static bool areUsedBy(const StrokeSettings& settings);

    void clear();

    /// Notes that vertices of the region that the stroke comes to for the first time have not moved. Precondition: the
    /// mesh is not refined under the brush yet. `mirror`: of a dab that is done on both sides, or null.
    void meet(const Region& region, MirrorMap* mirror);
    /// Gives vertices that were put into the region since then their neighbours' mean, and mends doubtful ones. Images
    /// get the same.
    void fill(const Region& region, const Mesh& mesh, MirrorMap* mirror);
    /// Adds the region's displacements after a dab that reached `share` of its plan.
    void note(const Region& region, const Mesh& mesh, double share, MirrorMap* mirror);

    /// Doubts the displacements of vertices around which the mesh was changed: fill() compares them with the surface.
    void doubt(const SlotSet& remeshed);

    void set(Slot v, const std::optional<Vec3>& displacement);
    /// Returns nothing for a vertex that the stroke has not come to, or has removed.
    std::optional<Vec3> of(Slot v) const;
    /// Returns the normal that the surface had at a vertex before the stroke moved it, of unit length, or zero.
    Vec3 normalAtRest(Slot v, const Mesh& mesh) const;
    /// Returns where the corners of a face were before the stroke moved them, by at most longest().
    std::array<Vec3, 3> cornersAtRest(Slot f, const Mesh& mesh) const;
    double longest() const { return m_longest; }
    /// Returns where a point of the surface was before the stroke moved it.
    Vec3 atRest(const SurfaceHit& hit, const Mesh& mesh) const;
    /// Returns where a point of the surface as it was before the stroke is now.
    Vec3 now(const SurfaceHit& atRest, const Mesh& mesh) const;

private:
    Vec3 displacementIn(const Triangle& corners, const std::array<double, 3>& weights) const;
    Vec3 restPoint(Slot v, const Mesh& mesh) const;
    Vec3 meanAround(Slot v, const Mesh& mesh) const;
    Vec3 estimate(Slot v, const Mesh& mesh) const;
    Vec3 believed(Slot v, const Mesh& mesh) const;
    void set(Slot v, const std::optional<Vec3>& displacement, MirrorMap* mirror);

    SparseIndex m_vertices;
    std::vector<std::optional<Vec3>> m_displacements; ///< by position among them
    double m_longest = 0;
    SlotSet m_doubtful;
};
} // namespace core
