#include "free_topology.h"

#include "shell_probe.h"
#include "surface_query.h"
#include "triangle_mesh.h"

namespace core
{
namespace
{
/// Edges of 0.13 to 0.16 radii, between d and d_detail of a brush of the sphere's radius.
constexpr int sphereSubdivisions = 3;
/// d_thickness in terms of d_detail: the least distance from every triangle.
constexpr double clearPerDetail = 0.735;

/// By ray parity, as the paper has it, and by distance: a large triangle may be near though no vertex is.
Refusal refusalOf(const JudgedMesh& surface, const Sphere& ball)
{
    const Mesh& mesh = surface.mesh();
    const Lattice& lattice = mesh.lattice();
    if (!lattice.contains(ball.center.cwiseAbs() + Vec3::Constant(ball.radius)))
        return Refusal::Wall;
    ShellProbe probe(lattice.toLattice(lattice.snap(ball.center)));
    surface.octree().query(probe.column(), [&](Slot f) {
        const Triangle& t = mesh.corners(f);
        probe.castAt({mesh.latticePoint(t[0]), mesh.latticePoint(t[1]), mesh.latticePoint(t[2])});
    });
    if (probe.isInside())
        return Refusal::Inside;
    const double clearance = clearPerDetail * edgeBounds(ball.radius, 1).detail;
    const std::optional<SurfaceHit> nearest = nearestPoint(mesh, surface.octree(), ball.center);
    return nearest && nearest->distance < ball.radius + clearance ? Refusal::TooClose : Refusal::None;
}

Surgery sphereAt(const Sphere& ball, const JudgedMesh& surface)
{
    const Mesh& mesh = surface.mesh();
    TriangleMesh sphere = icosphere(sphereSubdivisions, ball.radius);
    for (Vec3f& p : sphere.points)
        p = mesh.lattice().snap(ball.center + p.cast<double>());
    return additionOf(sphere, mesh.corners(nearestPoint(mesh, surface.octree(), ball.center)->face)[0]);
}
} // namespace

DabReport addSphere(JudgedMesh& surface, const Sphere& ball)
{
    Mesh& mesh = surface.mesh();
    DabReport report;
    report.outcome = DabOutcome::Refused;
    report.refusal = refusalOf(surface, ball);
    if (report.refusal != Refusal::None)
        return report;
    const Surgery sphere = sphereAt(ball, surface);
    if (!surface.attempt([&] { mesh.replaceFaces(sphere); })) {
        report.refusal = Refusal::TooClose;
        return report;
    }
    report.outcome = DabOutcome::Added;
    report.touchedVertices = static_cast<std::uint32_t>(sphere.vertices.size());
    report.touchedFaces = static_cast<std::uint32_t>(sphere.faces.size());
    return report;
}
} // namespace core
