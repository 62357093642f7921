#include "tests/support/cgal_judge.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;

std::optional<SurfaceMesh> surfaceMeshOf(const core::TriangleMesh& mesh)
{
    std::vector<std::vector<std::size_t>> polygons;
    for (const core::Triangle& t : mesh.triangles)
        polygons.push_back({t[0], t[1], t[2]});
    if (!PMP::is_polygon_soup_a_polygon_mesh(polygons))
        return std::nullopt;
    SurfaceMesh result;
    std::vector<SurfaceMesh::Vertex_index> vertices(mesh.points.size());
    for (const std::vector<std::size_t>& polygon : polygons) {
        for (const std::size_t v : polygon) {
            const core::Vec3 p = mesh.points[v].cast<double>();
            if (!vertices[v].is_valid())
                vertices[v] = result.add_vertex({p.x(), p.y(), p.z()});
        }
        if (!result.add_face(vertices[polygon[0]], vertices[polygon[1]], vertices[polygon[2]]).is_valid())
            return std::nullopt;
    }
    return result;
}
} // namespace

std::optional<CgalVerdict> judgedByCgal(const core::TriangleMesh& mesh)
{
    const std::optional<SurfaceMesh> surface = surfaceMeshOf(mesh);
    if (!surface || !CGAL::is_valid_polygon_mesh(*surface))
        return std::nullopt;
    CgalVerdict verdict;
    verdict.closed = CGAL::is_closed(*surface);
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    PMP::self_intersections(*surface, std::back_inserter(pairs));
    verdict.intersections = pairs.size();
    if (verdict.closed && pairs.empty())
        verdict.boundsSolid = PMP::does_bound_a_volume(*surface) && PMP::is_outward_oriented(*surface);
    return verdict;
}
