#include "core/sculpt/boolean_dab.h"

#include "core/sculpt/verified_remesh.h"
#include "core/sculpt/verify/mesh_transaction.h"
#include "core/util/phase_timer.h"

#include <algorithm>

namespace core
{
namespace
{
/// Number of tries, and lattice units by which each further try grows the solid. Growing it moves its faces out of
/// planes that contain faces of the model.
constexpr int maxTries = 3;
const Vec3 growth(3, 5, 7);

/// Returns the mirror image of the surgery.
Surgery imageOf(const Surgery& surgery, MirrorMap& mirror)
{
    Surgery image;
    image.nearby = mirror.imageOf(surgery.nearby);
    for (Slot f : surgery.removed)
        image.removed.push_back(mirror.imageOfFace(f));
    for (Surgery::Vertex vertex : surgery.vertices) {
        vertex.point = mirror.imageOf(vertex.point);
        image.vertices.push_back(vertex);
    }
    const auto imageOfCorner = [&](Slot corner) { return Surgery::isNew(corner) ? corner : mirror.imageOf(corner); };
    for (const auto& [a, b, c] : surgery.faces)
        image.faces.push_back({imageOfCorner(a), imageOfCorner(c), imageOfCorner(b)});
    return image;
}

/// Applies the surgery, and its image with a mirror, and selects the vertices of the new faces. Returns false if the
/// result would not be a closed 2-manifold; the mesh may have changed then.
bool exchange(DabContext& context, const Surgery& surgery)
{
    Mesh& mesh = context.surface.mesh();
    Region& region = context.region;
    MirrorMap* mirror = context.mirror;
    if (!isSurgeryOk(mesh, surgery))
        return false;
    const auto distance = [&](Slot v) { return (mesh.point(v).cast<double>() - context.ball.center).norm(); };
    region.clear();
    for (const Triangle& face : surgery.faces) {
        for (Slot v : face) {
            if (!Surgery::isNew(v))
                region.add(v, distance(v));
        }
    }
    if (context.rest())
        context.rest()->measure(region, mesh);
    std::optional<Surgery> image;
    if (mirror)
        image = imageOf(surgery, *mirror);
    const std::vector<Slot> added = mesh.replaceFaces(surgery);
    if (image) {
        if (!isSurgeryOk(mesh, *image))
            return false;
        const std::vector<Slot> images = mesh.replaceFaces(*image);
        for (std::size_t i = 0; i < added.size(); ++i)
            mirror->pair(added[i], images[i]);
    }
    region.forEach([&](Slot v) {
        if (!mesh.isVertex(v))
            region.remove(v);
    });
    for (Slot v : added) {
        region.add(v, distance(v));
        if (context.rest())
            context.rest()->noteNew(v);
    }
    return true;
}

/// Returns whether the faces are on the mirror's positive side and have mirror images.
bool canMirror(DabContext& context, const std::vector<Slot>& faces)
{
    MirrorMap& mirror = *context.mirror;
    return std::ranges::all_of(faces, [&](Slot f) { return mirror.isInHalf(context.mesh().corners(f)); }) &&
           mirror.learn(faces, context.surface.octree());
}

/// Returns whether a face to be removed has a masked corner.
bool touchesMask(const Mesh& mesh, const Surgery& surgery)
{
    return std::ranges::any_of(surgery.removed, [&](Slot f) {
        return std::ranges::any_of(mesh.corners(f), [&](Slot v) { return mesh.freedom(v) < 1; });
    });
}

/// Optimises the mesh around the changed vertices. Leaves it as it is if that does not verify.
void optimiseAround(DabContext& context)
{
    if (context.settings.topology == Topology::Keep)
        return;
    const PhaseTimer timer(context.report.optimiseMs, context.surface.verifyMs());
    const auto place = [&](Slot v) { return relaxedAlongSharp(context.mesh(), context.bounds, v); };
    const auto optimiseSharp = [&] {
        MeshEditor edit = context.editor();
        return optimiseKeepingShape(edit, context.region, context.bounds, place, context.rest());
    };
    remeshVerified(context, optimiseSharp);
}
} // namespace

PlacedSolid::PlacedSolid(TriangleMesh ofMesh, std::vector<Vec3> ofPlaces, const Vec3& center)
    : mesh(std::move(ofMesh))
    , places(std::move(ofPlaces))
{
    for (const Vec3& p : places)
        outward.push_back((p - center).cwiseSign());
}

void PlacedSolid::addImage(const MirrorMap& mirror)
{
    const std::size_t count = places.size(), faces = mesh.triangles.size();
    for (std::size_t v = 0; v < count; ++v) {
        mesh.points.push_back(mesh.points[v]);
        places.push_back(mirror.imageOf(places[v]));
        // without the factor 2, the grown solid and its grown image could touch along edges or in corners
        outward.push_back(2 * mirror.imageOf(outward[v]));
    }
    const auto first = static_cast<Slot>(count);
    for (std::size_t f = 0; f < faces; ++f) {
        const auto [a, b, c] = mesh.triangles[f];
        mesh.triangles.push_back({first + a, first + c, first + b});
    }
}

BooleanOutcome applyBoolean(DabContext& context, PlacedSolid solid, BooleanOperation operation)
{
    const Lattice& lattice = context.mesh().lattice();
    for (int i = 0; i < maxTries; ++i) {
        for (std::size_t v = 0; v < solid.places.size(); ++v) {
            const Vec3 p = solid.places[v] + i * lattice.unit() * growth.cwiseProduct(solid.outward[v]);
            if (!lattice.contains(p))
                return BooleanOutcome::Failed;
            solid.mesh.points[v] = lattice.snap(p);
        }
        std::optional<Surgery> surgery;
        {
            const PhaseTimer timer(context.report.deformMs);
            const SolidBoolean boolean(context.surface, solid.mesh);
            if (!boolean.areCrossing())
                return BooleanOutcome::Apart;
            surgery = boolean.surgery(operation);
            if (surgery && touchesMask(context.mesh(), *surgery))
                return BooleanOutcome::Masked;
            if (surgery && context.mirror && !canMirror(context, surgery->removed))
                return BooleanOutcome::Failed;
        }
        MeshTransaction transaction(context.surface, context.region);
        if (surgery && exchange(context, *surgery) && transaction.commit()) {
            ++context.request.totals.fusions;
            optimiseAround(context);
            return BooleanOutcome::Done;
        }
    }
    return BooleanOutcome::Failed;
}

BooleanOutcome uniteOnBothSides(DabContext& context, PlacedSolid solid)
{
    BooleanOutcome outcome = applyBoolean(context, solid, BooleanOperation::Unite);
    if (outcome != BooleanOutcome::Failed || !context.mirror)
        return outcome;
    MirrorMap* mirror = std::exchange(context.mirror, nullptr);
    if (mirror->imageOf(context.dab.position) != context.dab.position)
        solid.addImage(*mirror);
    outcome = applyBoolean(context, std::move(solid), BooleanOperation::Unite);
    context.report.asymmetric = outcome == BooleanOutcome::Done;
    if (outcome != BooleanOutcome::Done)
        context.mirror = mirror;
    return outcome;
}
} // namespace core
