#include "core/sculpt/add_solid.h"

#include "core/analysis/shell_orientation.h"
#include "core/geometry/triangle_mesh.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/surface_query.h"
#include "core/sculpt/boolean_dab.h"
#include "core/sculpt/deform/brush_model.h"
#include "core/sculpt/deform/dab_frame.h"

#include <algorithm>
#include <utility>

namespace core
{
namespace
{
/// Subdivisions of the icosahedron for a sphere. Its edges are 0.13 to 0.16 radii long, between d and d_detail of a
/// brush of that radius.
constexpr int sphereSubdivisions = 3;

/// Returns the smallest allowed distance, in mm, between a new solid and the surface: d_thickness of a brush of the
/// solid's radius.
double clearanceOf(const Sphere& ball)
{
    return edgeBounds(ball.radius, 1).thickness();
}

/// Returns the reason why a sphere must not be added there. Inside or outside is decided by ray parity, as in the
/// paper; clearance by the distance to the nearest face, because a large face may be near although its corners are not.
Refusal refusalOf(const VerifiedMesh& surface, const Sphere& ball)
{
    const Mesh& mesh = surface.mesh();
    const Lattice& lattice = mesh.lattice();
    if (!lattice.contains(ball.center.cwiseAbs() + Vec3::Constant(ball.radius)))
        return Refusal::Wall;
    ShellOrientation probe(lattice.toLattice(lattice.snap(ball.center)));
    surface.octree().query(probe.column(), [&](Slot f) {
        const Triangle& t = mesh.corners(f);
        probe.castAt({mesh.latticePoint(t[0]), mesh.latticePoint(t[1]), mesh.latticePoint(t[2])});
    });
    if (probe.isInside())
        return Refusal::Inside;
    const std::optional<SurfaceHit> nearest = nearestPoint(mesh, surface.octree(), ball.center);
    return nearest && nearest->distance < ball.radius + clearanceOf(ball) ? Refusal::TooClose : Refusal::None;
}

Slot nearestVertex(const VerifiedMesh& surface, const Vec3& p)
{
    return surface.mesh().corners(nearestPoint(surface.mesh(), surface.octree(), p)->face)[0];
}

void reverseOrientation(TriangleMesh& shell)
{
    for (Triangle& t : shell.triangles)
        std::swap(t[1], t[2]);
}

/// Returns the solid's mesh. `places` receives the positions of its points, mm, not yet snapped to the lattice.
TriangleMesh solidAt(const Dab& dab, const BrushModel* model, std::vector<Vec3>& places)
{
    TriangleMesh solid = model ? model->surface() : icosphere(sphereSubdivisions, dab.radius);
    const DabFrame frame = uprightFrame(dab);
    for (const Vec3f& point : solid.points) {
        const Vec3 p = point.cast<double>();
        places.push_back(
            dab.position +
            (model ? Vec3(dab.radius * (p.x() * frame.right + p.y() * frame.normal - p.z() * frame.up)) : p));
    }
    if (model && dab.isMirrored)
        reverseOrientation(solid);
    return solid;
}

TriangleMesh imageOf(TriangleMesh shell, const MirrorMap& mirror)
{
    for (Vec3f& p : shell.points)
        p = mirror.imageOf(p);
    reverseOrientation(shell);
    return shell;
}

/// Adds the solid as a separate shell, clear of the surface.
void addApart(VerifiedMesh& surface, const BrushModel* model, const Dab& dab, const MirrorMap* mirror,
              DabReport& report)
{
    Mesh& mesh = surface.mesh();
    const Sphere ball = {dab.position, dab.radius};
    const bool paired = mirror && mirror->imageOf(ball.center) != ball.center;
    const Sphere image = {paired ? mirror->imageOf(ball.center) : ball.center, ball.radius};
    report.outcome = DabOutcome::Refused;
    report.refusal = refusalOf(surface, ball);
    if (paired && report.refusal == Refusal::None)
        report.refusal = (image.center - ball.center).norm() < 2 * ball.radius + clearanceOf(ball)
                             ? Refusal::TooClose
                             : refusalOf(surface, image);
    if (report.refusal != Refusal::None)
        return;
    std::vector<Vec3> places;
    TriangleMesh solid = solidAt(dab, model, places);
    const Slot near = nearestVertex(surface, ball.center), nearImage = nearestVertex(surface, image.center);
    const auto add = [&](const std::vector<LatticePoint>& points) {
        std::ranges::transform(points, solid.points.begin(),
                               [&](const LatticePoint& p) { return mesh.lattice().toPoint(p); });
        return surface.tryOperation([&] {
            mesh.replaceFaces(additionOf(solid, near));
            if (paired)
                mesh.replaceFaces(additionOf(imageOf(solid, *mirror), nearImage));
        });
    };
    if (!add(snappedTo(mesh.lattice(), places))) {
        const LatticeFit fit = model ? fitToLattice(mesh.lattice(), places, solid.triangles) : LatticeFit();
        if (!model || fit.unsnappable > 0 || !add(fit.points)) {
            report.refusal = model ? Refusal::Unfit : Refusal::TooClose;
            return;
        }
    }
    const std::uint32_t shells = paired ? 2 : 1;
    report.outcome = DabOutcome::Added;
    report.touchedVertices = shells * static_cast<std::uint32_t>(solid.points.size());
    report.touchedFaces = shells * static_cast<std::uint32_t>(solid.triangles.size());
}

/// Unites the model with the solid, and with its image if there is a mirror. Returns false, with nothing changed, if
/// the surfaces do not cross or the solid leaves the working volume.
bool joinSolid(DabContext& context)
{
    std::vector<Vec3> places;
    TriangleMesh mesh = solidAt(context.dab, context.settings.model.get(), places);
    const Lattice& lattice = context.mesh().lattice();
    if (!std::ranges::all_of(places, [&](const Vec3& p) { return lattice.contains(p); }))
        return false;
    const BooleanOutcome outcome =
        uniteOnBothSides(context, PlacedSolid(std::move(mesh), std::move(places), context.dab.position));
    if (outcome == BooleanOutcome::Apart)
        return false;
    const bool isDone = outcome == BooleanOutcome::Done;
    context.report.outcome = isDone ? DabOutcome::Added : DabOutcome::Refused;
    context.report.refusal = isDone                              ? Refusal::None
                             : outcome == BooleanOutcome::Masked ? Refusal::Masked
                                                                 : Refusal::Unfit;
    context.report.touchedVertices = isDone ? context.touchedVertices() : 0;
    return true;
}
} // namespace

bool wantsSolid(const VerifiedMesh& surface, const StrokeSettings& settings, const Dab& dab, const Region& region)
{
    if (!settings.add || !canAddSolid(settings.tool) || settings.brush != BrushShape::Sphere ||
        settings.place != Placement::Point)
        return false;
    if (settings.join)
        return true;
    if (!region.empty())
        return false;
    const std::optional<SurfaceHit> nearest = nearestPoint(surface.mesh(), surface.octree(), dab.position);
    // otherwise a face is under the brush, although none of its corners is
    return !nearest || nearest->distance > dab.radius;
}

Refusal refusalOf(const VerifiedMesh& surface, const std::vector<Vec3>& centers, double radius)
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

void addSolid(DabContext& context)
{
    if (context.settings.join && context.settings.fusion && joinSolid(context))
        return;
    addApart(context.surface, context.settings.model.get(), context.dab, context.mirror, context.report);
}
} // namespace core
