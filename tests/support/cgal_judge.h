#pragma once

#include "core/geometry/triangle_mesh.h"

#include <optional>

/// CGAL's verdict on a mesh: a check that is independent of Fettle's own code.
struct CgalVerdict
{
    bool closed = false;
    std::size_t intersections = 0; ///< number of intersecting pairs of faces
    bool boundsSolid = false;      ///< closed, no intersections, bounds a volume and faces outwards

    bool allWell() const { return closed && intersections == 0 && boundsSolid; }
};

/// Returns CGAL's verdict, or nothing if the faces are not a consistently oriented manifold. Unused vertices are
/// ignored.
std::optional<CgalVerdict> judgedByCgal(const core::TriangleMesh& mesh);
