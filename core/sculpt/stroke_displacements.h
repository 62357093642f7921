#pragma once

#include "core/mesh/surface_hit.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/util/sparse_index.h"

namespace core
{
/// How far a stroke has moved each vertex, in mm. The tool Layer raises the surface to one height by it, however often
/// a stroke passes; and the dabs of a path over the surface stand on it as it was before.
class StrokeDisplacements
{
public:
    /// Whether strokes with these settings need it.
    static bool areUsedBy(const StrokeSettings& settings);

    void clear();

    /// Lets each vertex of the region carry the length of its displacement. A vertex that came since the dab before
    /// gets its neighbours' mean.
    void recall(Region& region, const Mesh& mesh) const;
    /// Adds the region's displacements after a dab that reached `share` of its plan. `mirror`: of a dab that is done on
    /// both sides, or null.
    void note(const Region& region, const Mesh& mesh, double share, MirrorMap* mirror);

    void set(Slot v, const std::optional<Vec3>& displacement);
    /// Returns nothing for a vertex that the stroke has not come to, or has removed.
    std::optional<Vec3> of(Slot v) const;
    /// Returns where a point of the surface was before the stroke moved it.
    Vec3 atRest(const SurfaceHit& hit, const Mesh& mesh) const;

private:
    Vec3 meanAround(Slot v, const Mesh& mesh) const;

    SparseIndex m_vertices;
    std::vector<std::optional<Vec3>> m_displacements; ///< by position among them
};
} // namespace core
