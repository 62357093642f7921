#include "free_topology.h"

#include "shell_probe.h"
#include "surface_query.h"
#include "triangle_mesh.h"

#include <algorithm>

namespace core
{
namespace
{
/// Edges of 0.13 to 0.16 radii, between d and d_detail of a brush of the sphere's radius.
constexpr int sphereSubdivisions = 3;
/// d_thickness in terms of d_detail: the least distance from every triangle.
constexpr double clearPerDetail = 0.735;

double clearanceOf(const Sphere& ball)
{
    return clearPerDetail * edgeBounds(ball.radius, 1).detail;
}

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
    const std::optional<SurfaceHit> nearest = nearestPoint(mesh, surface.octree(), ball.center);
    return nearest && nearest->distance < ball.radius + clearanceOf(ball) ? Refusal::TooClose : Refusal::None;
}

Slot nearestVertex(const JudgedMesh& surface, const Vec3& p)
{
    return surface.mesh().corners(nearestPoint(surface.mesh(), surface.octree(), p)->face)[0];
}

TriangleMesh sphereAt(const Sphere& ball, const Lattice& lattice)
{
    TriangleMesh sphere = icosphere(sphereSubdivisions, ball.radius);
    for (Vec3f& p : sphere.points)
        p = lattice.snap(ball.center + p.cast<double>());
    return sphere;
}

TriangleMesh imageOf(TriangleMesh shell, const MirrorMap& mirror)
{
    for (Vec3f& p : shell.points)
        p = mirror.imageOf(p);
    for (Triangle& t : shell.triangles)
        std::swap(t[1], t[2]);
    return shell;
}
} // namespace

Refusal refusalOf(const JudgedMesh& surface, const std::vector<Vec3>& centers, double radius)
{
    for (const Vec3& center : centers) {
        if (const Refusal refusal = refusalOf(surface, {center, radius}); refusal != Refusal::None)
            return refusal;
        const double clear = 2 * radius + clearanceOf({center, radius});
        const auto isTooClose = [&](const Vec3& other) { return other != center && (other - center).norm() < clear; };
        if (std::ranges::any_of(centers, isTooClose))
            return Refusal::TooClose;
    }
    return Refusal::None;
}

DabReport addSphere(JudgedMesh& surface, const Sphere& ball, const MirrorMap* mirror)
{
    Mesh& mesh = surface.mesh();
    const bool paired = mirror && mirror->imageOf(ball.center) != ball.center;
    const Sphere image = {paired ? mirror->imageOf(ball.center) : ball.center, ball.radius};
    DabReport report;
    report.outcome = DabOutcome::Refused;
    report.refusal = refusalOf(surface, ball);
    if (paired && report.refusal == Refusal::None)
        report.refusal = (image.center - ball.center).norm() < 2 * ball.radius + clearanceOf(ball) ? Refusal::TooClose
                                                                                                  : refusalOf(surface, image);
    if (report.refusal != Refusal::None)
        return report;
    const TriangleMesh sphere = sphereAt(ball, mesh.lattice());
    const Slot near = nearestVertex(surface, ball.center), nearImage = nearestVertex(surface, image.center);
    const auto add = [&] {
        mesh.replaceFaces(additionOf(sphere, near));
        if (paired)
            mesh.replaceFaces(additionOf(imageOf(sphere, *mirror), nearImage));
    };
    if (!surface.attempt(add)) {
        report.refusal = Refusal::TooClose;
        return report;
    }
    const std::uint32_t shells = paired ? 2 : 1;
    report.outcome = DabOutcome::Added;
    report.touchedVertices = shells * static_cast<std::uint32_t>(sphere.points.size());
    report.touchedFaces = shells * static_cast<std::uint32_t>(sphere.triangles.size());
    return report;
}
} // namespace core
