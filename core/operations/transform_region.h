#pragma once

#include "core/mesh/footprint.h"
#include "core/mesh/mesh.h"

#include <memory>
#include <optional>

namespace core
{
/// The vertices that a Transform of a part moves, for its preview and its handles. Space: document, mm.
struct TransformRegion
{
    Box box;   ///< of the vertices that move; empty if none does
    Box whole; ///< of the part
    /// Centre about which to turn: the middle of the border to what is masked or hidden, or that of the box
    Vec3 centre = Vec3::Zero();
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity(); ///< the part's own axes
    /// The vertices that move, with their freedom from 1 to 255
    std::shared_ptr<const Footprint> vertices;
    std::shared_ptr<const Footprint> all; ///< every vertex of the part, with weight 255
};

/// Returns the region that a Transform of the part moves; `part`: nothing means all parts, with the document's axes.
/// Cost: O(mesh).
TransformRegion transformRegionOf(const Mesh& mesh, std::optional<PartId> part);
} // namespace core
