#pragma once

#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/util/sparse_index.h"

namespace core
{
/// How far the tool Layer has raised each vertex in a stroke, in mm. So a stroke raises the surface to one height,
/// however often it passes.
class LayerHeights
{
public:
    void clear();

    /// Lets each vertex of the region carry its height. A vertex that came since the dab before gets its neighbours'
    /// mean.
    void recall(Region& region, const Mesh& mesh) const;
    /// Notes the heights after a dab that reached `share` of its plan. `mirror`: of a dab that is done on both sides,
    /// or null.
    void note(const Region& region, double share, MirrorMap* mirror);

    void set(Slot v, double height);
    /// Returns a negative height if none is known.
    double of(Slot v) const;

private:
    double meanAround(Slot v, const Mesh& mesh) const;

    SparseIndex m_vertices;
    std::vector<double> m_heights; ///< by position among them; negative: the vertex is gone
};
} // namespace core
