#pragma once

#include "core/sculpt/remesh/remesh_pass.h"

#include <optional>

namespace core
{
/// Collapses edges that are too short (paper, section 3.2.2).
class EdgeCollapse
{
public:
    /// `keepsShape`: see optimiseKeepingShape().
    EdgeCollapse(RemeshPass& pass, bool keepsShape);

    /// Collapses the edges, the shortest first, and the edges that become short on the way. Appends edges that no legal
    /// collapse can remove to RemeshCounts::blocked.
    void collapseShortEdges(std::vector<RemeshEdge> edges);

private:
    /// The vertex that results from a collapse.
    struct Merged
    {
        Vec3f point;
        Vec3 plan;        ///< planned displacement, mm
        double error = 0; ///< planeError() in units of d^2; set only if the shape is kept
    };
    using Choices = std::array<Merged, 3>;

    std::vector<RemeshEdge> collapse(std::vector<RemeshEdge> edges);
    std::optional<Merged> mergedEnds(Slot h) const;
    std::size_t keepShape(Slot h, Choices& choices) const;

    RemeshPass& m_pass;
    const Mesh& m_mesh;
    bool m_keepsShape;
    FaceLimits m_limits;
};
} // namespace core
