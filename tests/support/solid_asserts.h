#pragma once

#include "core/analysis/mesh_check.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/mesh_asserts.h"

namespace mesh_asserts
{
/// Returns the first defect of the mesh, or an empty text. Fettle's own check tests the links, CGAL the surface.
inline std::string unsoundness(const core::Mesh& mesh)
{
    const std::string links = brokenLinks(mesh);
    if (!links.empty())
        return links;
    const std::optional<CgalVerdict> verdict = judgedByCgal(surfaceOf(mesh));
    if (!verdict)
        return "not manifold or not oriented";
    if (!verdict->closed)
        return "not closed";
    if (verdict->intersections > 0)
        return std::to_string(verdict->intersections) + " pairs of faces intersect";
    return verdict->boundsSolid ? "" : "does not bound a solid";
}

/// Returns the enclosed volume. Precondition: the mesh is closed.
inline double volumeOf(const core::Mesh& mesh)
{
    return core::checkMesh(surfaceOf(mesh)).volume.value();
}

/// Returns whether the mesh has no defect and the octree contains exactly its faces.
inline bool isSound(const core::Sculptor& sculptor)
{
    return unsoundness(sculptor.mesh()).empty() && sculptor.indexIsConsistent();
}
} // namespace mesh_asserts

/// Checks that the mesh is consistently linked, closed, manifold, oriented, free of self-intersections and the boundary
/// of a solid. The test must link fettle_cgal_judge.
#define VERIFY_VALID(mesh)                                                                                             \
    do {                                                                                                               \
        const std::string unsoundness = mesh_asserts::unsoundness(mesh);                                               \
        QVERIFY2(unsoundness.empty(), unsoundness.c_str());                                                            \
    } while (false)
