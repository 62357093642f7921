#include "core/sculpt/boolean_dab.h"

#include "core/sculpt/fuse/mirrored_join.h"
#include "core/sculpt/verified_remesh.h"
#include "core/sculpt/verify/mesh_transaction.h"
#include "core/util/phase_timer.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>

namespace core
{
namespace
{
/// Number of tries, and lattice units by which each further try grows the solid. Growing it moves its faces out of
/// planes that contain faces of the model.
constexpr int maxTries = 3;
const Vec3 growth(3, 5, 7);

/// Returns whether the points are the mirror images of each other, in any order.
bool areOwnImage(std::vector<Vec3> points, const MirrorMap& mirror)
{
    const auto before = [](const Vec3& a, const Vec3& b) { return std::ranges::lexicographical_compare(a, b); };
    std::vector<Vec3> images;
    std::ranges::transform(points, std::back_inserter(images), [&](const Vec3& p) { return mirror.imageOf(p); });
    std::ranges::sort(points, before);
    std::ranges::sort(images, before);
    return points == images;
}

/// Adds the solid's mirror image as a second shell, which may cross the first.
void addImage(PlacedSolid& solid, const MirrorMap& mirror)
{
    TriangleMesh& mesh = solid.mesh;
    std::vector<Vec3>&places = solid.places, &outward = solid.outward;
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

/// If the solid is its own mirror image, divides the faces that cross the plane, and returns true. Otherwise returns
/// false, with nothing changed.
bool divideAtPlane(PlacedSolid& solid, const MirrorMap& mirror)
{
    TriangleMesh& mesh = solid.mesh;
    std::vector<Vec3>&places = solid.places, &outward = solid.outward;
    const auto isAcross = [&](Slot a, Slot b) { return mirror.height(places[a]) * mirror.height(places[b]) < 0; };
    const auto forEachAcross = [&](auto visit) { // a face has one such edge at most
        for (std::size_t f = 0, count = mesh.triangles.size(); f < count; ++f) {
            const Triangle face = mesh.triangles[f];
            for (std::size_t i = 0; i < 3; ++i) {
                if (isAcross(face[i], face[(i + 1) % 3]))
                    visit(f, i);
            }
        }
    };
    bool isOwnImage = areOwnImage(places, mirror);
    forEachAcross([&](std::size_t f, std::size_t i) {
        const Triangle& face = mesh.triangles[f];
        isOwnImage = isOwnImage && places[face[(i + 1) % 3]] == mirror.imageOf(places[face[i]]);
    });
    if (!isOwnImage)
        return false;
    std::map<std::pair<Slot, Slot>, Slot> middles;
    forEachAcross([&](std::size_t f, std::size_t i) {
        const Triangle face = mesh.triangles[f];
        const Slot a = face[i], b = face[(i + 1) % 3], c = face[(i + 2) % 3];
        const auto [middle, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<Slot>(places.size()));
        if (isNew) {
            mesh.points.push_back(Vec3f(mesh.points[a]));
            places.push_back(mirror.onPlane(places[a]));
            outward.push_back(mirror.onPlane(outward[a]));
        }
        mesh.triangles[f] = {a, middle->second, c};
        mesh.triangles.push_back({middle->second, b, c});
    });
    return true;
}

/// Splits the edges across the mirror plane of these faces. Returns whether there were any.
bool splitAcrossPlane(DabContext& context, std::vector<Slot> faces)
{
    MeshEditor edit = verifiedEditor(context);
    const std::size_t before = faces.size();
    const RemeshCounts counts =
        splitFacesAcross(edit, context.region, faces, context.ball, context.bounds, context.rest());
    context.candidates.insert(context.candidates.end(), faces.begin() + static_cast<std::ptrdiff_t>(before),
                              faces.end());
    context.request.displacements.doubt(context.region.remeshed());
    context.count(counts);
    return counts.splits > 0;
}

/// Returns the part of the surgery on the mirror's positive side, plane included; nothing if a face crosses the plane
/// or lies in it.
std::optional<Surgery> positiveHalf(const Surgery& surgery, const Mesh& mesh, const MirrorMap& mirror)
{
    const auto heightOf = [&](Slot corner) {
        return Surgery::isNew(corner) ? mirror.height(surgery.vertices[Surgery::newIndex(corner)].point)
                                      : mirror.height(corner);
    };
    bool isDivided = true;
    const auto isInHalf = [&](const Triangle& face) {
        const auto [least, most] = std::minmax({heightOf(face[0]), heightOf(face[1]), heightOf(face[2])});
        isDivided = isDivided && (least >= 0 || most <= 0) && (least != 0 || most != 0);
        return most > 0;
    };
    Surgery half = partOf(surgery, mesh, isInHalf);
    return isDivided ? std::optional(std::move(half)) : std::nullopt;
}

/// Returns the surgery on the mirror's positive side: all of it, or its half if the solid is its own image. Returns
/// nothing if it does not fit in there, or if a face to be removed has no image.
std::optional<Surgery> halfToMirror(DabContext& context, Surgery surgery, bool isOwnImage)
{
    const Mesh& mesh = context.mesh();
    MirrorMap& mirror = *context.mirror;
    if (isOwnImage) {
        std::optional<Surgery> half = positiveHalf(surgery, mesh, mirror);
        if (!half)
            return std::nullopt;
        surgery = std::move(*half);
    }
    const bool isInHalf =
        std::ranges::all_of(surgery.removed, [&](Slot f) { return mirror.isInHalf(mesh.corners(f)); });
    return isInHalf && mirror.learn(surgery.removed, context.surface.octree()) ? std::optional(std::move(surgery))
                                                                               : std::nullopt;
}

/// Stores which of the added vertices are each other's images. `added`: the vertices of withImage(half), in its order.
void pairAdded(MirrorMap& mirror, const Surgery& half, const std::vector<Slot>& added)
{
    std::size_t image = half.vertices.size();
    for (std::size_t i = 0; i < half.vertices.size(); ++i) {
        if (mirror.height(half.vertices[i].point) > 0)
            mirror.pair(added[i], added[image++]);
    }
}

/// Applies the surgery, and its image with a mirror, and selects the vertices of the new faces. Returns false, with the
/// mesh unchanged, if the result would not be a closed 2-manifold.
bool exchange(DabContext& context, const Surgery& surgery)
{
    Mesh& mesh = context.surface.mesh();
    Region& region = context.region;
    MirrorMap* mirror = context.mirror;
    const std::optional<Surgery> both = mirror ? withImage(mesh, *mirror, surgery) : std::nullopt;
    if (mirror ? !both : !isSurgeryOk(mesh, surgery))
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
    const std::vector<Slot> added = mesh.replaceFaces(both ? *both : surgery);
    if (mirror)
        pairAdded(*mirror, surgery, added);
    region.forEach([&](Slot v) {
        if (!mesh.isVertex(v))
            region.remove(v);
    });
    for (Slot v : std::span(added).first(surgery.vertices.size())) {
        region.add(v, distance(v));
        if (context.rest())
            context.rest()->noteNew(v);
    }
    return true;
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

BooleanOutcome applyBoolean(DabContext& context, PlacedSolid solid, BooleanOperation operation)
{
    const Lattice& lattice = context.mesh().lattice();
    const bool isOwnImage = context.mirror && divideAtPlane(solid, *context.mirror);
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
            std::optional<SolidBoolean> boolean(std::in_place, context.surface, solid.mesh);
            if (!boolean->areCrossing())
                return BooleanOutcome::Apart;
            if (isOwnImage && splitAcrossPlane(context, boolean->candidates()))
                boolean.emplace(context.surface, solid.mesh);
            surgery = boolean->surgery(operation);
            if (surgery && touchesMask(context.mesh(), *surgery))
                return BooleanOutcome::Masked;
            if (surgery && context.mirror) {
                surgery = halfToMirror(context, std::move(*surgery), isOwnImage);
                if (!surgery && !isOwnImage)
                    return BooleanOutcome::Failed; // a larger solid would not fit either
            }
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
        addImage(solid, *mirror);
    outcome = applyBoolean(context, std::move(solid), BooleanOperation::Unite);
    context.report.asymmetric = outcome == BooleanOutcome::Done;
    if (outcome != BooleanOutcome::Done)
        context.mirror = mirror;
    return outcome;
}
} // namespace core
