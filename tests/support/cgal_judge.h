#pragma once

#include "core/geometry/triangle_mesh.h"

#include <optional>

/// What CGAL says of a mesh: the independent judge of all that Fettle promises.
struct CgalVerdict
{
    bool closed = false;
    std::size_t intersections = 0; ///< pairs of faces
    bool boundsSolid = false;      ///< closed, no intersections, bounds a volume and faces outwards

    bool allWell() const { return closed && intersections == 0 && boundsSolid; }
};

/// Nothing if the faces do not form a manifold, consistently oriented mesh. Unused vertices are left out.
std::optional<CgalVerdict> judgedByCgal(const core::TriangleMesh& mesh);
