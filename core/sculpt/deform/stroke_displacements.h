#pragma once

#include "core/mesh/surface_hit.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/util/sparse_index.h"

namespace core
{
/// Tracks how far a stroke has moved each vertex, in mm, rounded to the lattice. Layer uses it to raise the surface to
/// one height, however often a stroke passes. Strokes along the surface use it to place their dabs on the surface as it
/// was before the stroke.
class StrokeDisplacements
{
public:
    /// Returns whether strokes with these settings need displacements.
    static bool areUsedBy(const StrokeSettings& settings);

    void clear();

    /// Sets the displacement of the region's vertices that have none yet to zero. Precondition: the mesh under the
    /// brush has not been refined yet. `mirror`: the mirror of a dab done on both sides, or null.
    void meet(const Region& region, MirrorMap* mirror);
    /// Gives vertices created since meet() the mean displacement of their neighbours, and corrects doubtful
    /// displacements. Mirror images get the mirrored values.
    void fill(const Region& region, const Mesh& mesh, MirrorMap* mirror);
    /// Adds the region's motion, after a dab that reached `share` (0 to 1) of its plan.
    void note(const Region& region, const Mesh& mesh, double share, MirrorMap* mirror);

    /// Marks the displacements of vertices around which the mesh was changed as doubtful: fill() compares them with the
    /// surface.
    void doubt(const SlotSet& remeshed);

    void set(Slot v, const std::optional<Vec3>& displacement);
    /// Returns the displacement of v, mm; nothing if the stroke has not reached v yet, or has removed it.
    std::optional<Vec3> of(Slot v) const;
    /// Returns the unit normal of the surface at v before the stroke moved it, or zero.
    Vec3 normalAtRest(Slot v, const Mesh& mesh) const;
    /// Returns the positions of a face's corners before the stroke moved them. Each has moved by at most longest().
    std::array<Vec3, 3> cornersAtRest(Slot f, const Mesh& mesh) const;
    double longest() const { return m_longest; }
    /// Returns the position of a surface point before the stroke moved it.
    Vec3 atRest(const SurfaceHit& hit, const Mesh& mesh) const;
    /// Returns the current position of a point on the surface as it was before the stroke.
    Vec3 now(const SurfaceHit& atRest, const Mesh& mesh) const;

private:
    Vec3 displacementIn(const Triangle& corners, const std::array<double, 3>& weights) const;
    Vec3 restPoint(Slot v, const Mesh& mesh) const;
    Vec3 meanAround(Slot v, const Mesh& mesh) const;
    Vec3 estimate(Slot v, const Mesh& mesh) const;
    Vec3 believed(Slot v, const Mesh& mesh) const;
    void set(Slot v, const std::optional<Vec3>& displacement, MirrorMap* mirror);

    SparseIndex m_vertices;
    std::vector<std::optional<Vec3>> m_displacements; ///< displacements, mm, by position in m_vertices
    double m_longest = 0;
    SlotSet m_doubtful;
};
} // namespace core
