#pragma once

#include "core/analysis/mesh_check.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/cgal_judge.h"
#include "tests/support/mesh_asserts.h"

namespace mesh_asserts
{
/// What is wrong with the mesh: its links, by our own check; its surface, by CGAL. Empty if nothing is.
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

/// Precondition: it is closed.
inline double volumeOf(const core::Mesh& mesh)
{
    return core::checkMesh(surfaceOf(mesh)).volume.value();
}

/// Whether nothing is wrong with the mesh, and the octree holds its faces.
inline bool isSound(const core::Sculptor& sculptor)
{
    return unsoundness(sculptor.mesh()).empty() && sculptor.indexIsConsistent();
}
} // namespace mesh_asserts

/// Linked rightly, closed, manifold, oriented, free of self-intersections, the boundary of a solid. Links
/// fettle_cgal_judge.
#define VERIFY_VALID(mesh)                                                                                             \
    do {                                                                                                               \
        const std::string unsoundness = mesh_asserts::unsoundness(mesh);                                               \
        QVERIFY2(unsoundness.empty(), unsoundness.c_str());                                                            \
    } while (false)
