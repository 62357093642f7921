#include "core/operations/mirror_image.h"

#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/surface_exchange.h"
#include "core/operations/symmetrize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace core
{
namespace
{
/// Returns whether each vertex has a mirror image, bit for bit.
bool hasImages(const Mesh& mesh, Symmetry plane)
{
    const SurfaceIndex index(mesh);
    return std::ranges::all_of(mesh.vertices(), [&](Slot v) {
        SurfaceIndex::Place place = SurfaceIndex::placeOf(mesh.latticePoint(v));
        place[static_cast<std::size_t>(axisOf(plane))] *= -1;
        return index.vertexAt(place) != noSlot;
    });
}
} // namespace

TriangleMesh mirrorImage(TriangleMesh surface, Symmetry plane)
{
    const int axis = axisOf(plane);
    for (Vec3f& p : surface.points)
        p[axis] = 0 - p[axis];
    for (Triangle& t : surface.triangles)
        std::swap(t[1], t[2]);
    return surface;
}

Box mirrorImage(const Box& box, Symmetry plane)
{
    Box image;
    image.extend(mirrored(box.min(), plane));
    image.extend(mirrored(box.max(), plane));
    return image;
}

void putOnPlane(Vec3& place, Vec3& direction, Symmetry plane)
{
    constexpr double rightAngle = 0.999; // cosine of 2.5 degrees
    const int axis = axisOf(plane);
    place[axis] = 0;
    if (std::abs(direction.stableNormalized()[axis]) < rightAngle)
        direction[axis] = 0;
}

TriangleMesh besideImage(TriangleMesh surface, Symmetry plane)
{
    if (plane == Symmetry::None)
        return surface;
    const TriangleMesh image = mirrorImage(surface, plane);
    const auto added = static_cast<Slot>(surface.points.size());
    std::ranges::copy(image.points, std::back_inserter(surface.points));
    std::ranges::copy(image.colors, std::back_inserter(surface.colors));
    for (const auto& [a, b, c] : image.triangles)
        surface.triangles.push_back({a + added, b + added, c + added});
    return surface;
}

std::optional<TriangleMesh> withMirrorImage(TriangleMesh solid, const Lattice& lattice, Symmetry plane,
                                            ModelChange& change, const JobControl& control)
{
    solid.masks.clear();
    if (!fitSurface(solid, lattice, change, control))
        return std::nullopt;
    const Box box = boxOf(solid);
    if (!box.intersects(mirrorImage(box, plane)))
        return besideImage(std::move(solid), plane);
    auto mesh = std::make_unique<Mesh>(solid, lattice);
    if (isSymmetric(*mesh, plane))
        return solid;
    // A tube along the plane is its own image but for the diagonals of its faces, along which the union would be cut.
    if (!hasImages(*mesh, plane)) {
        const std::array<TriangleMesh, 2> both = {solid, mirrorImage(solid, plane)};
        const BooleanResult united = combineOn(lattice, SetOperation::Union, both, {control.stop, {}});
        mesh = united.mesh ? std::make_unique<Mesh>(withoutUnusedVertices(*united.mesh), lattice) : nullptr;
    }
    if (mesh) {
        mesh->beginStroke();
        const bool isMirrored = isSymmetric(*mesh, plane) || mirrorHalf(*mesh, plane, {control.stop, {}});
        mesh->endStroke();
        if (isMirrored)
            return extractMesh(*mesh);
    }
    change.refusal = ModelRefusal::Uncut;
    return std::nullopt;
}

bool mirrorHalf(Mesh& mesh, Symmetry plane, const JobControl& control)
{
    for (const Half kept : {Half::Positive, Half::Negative}) {
        ModelChange change;
        symmetrize(mesh, {plane, kept}, change, control);
        if (change.refusal == ModelRefusal::None)
            return !control.isCancelled();
    }
    return false;
}
} // namespace core
