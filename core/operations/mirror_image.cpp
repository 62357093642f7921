#include "core/operations/mirror_image.h"

#include "core/geometry/face_geometry.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/surface_exchange.h"
#include "core/operations/symmetrize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace core
{
namespace
{
/// Largest difference of the volumes of a tube along the plane and of its half with its image, as a share.
constexpr double sameVolume = 1e-3;

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

/// The colours, masks and hidden state of the vertices, by place.
class AttributesByPlace
{
public:
    explicit AttributesByPlace(const Mesh& mesh)
    {
        for (const Slot v : mesh.vertices())
            m_all.push_back(
                {SurfaceIndex::placeOf(mesh.latticePoint(v)), mesh.color(v), mesh.mask(v), mesh.isHidden(v)});
        std::ranges::sort(m_all, {}, &Entry::place);
    }

    /// Gives them to the vertices of the mesh that are at these places.
    void writeTo(Mesh& mesh) const
    {
        for (const Slot v : mesh.vertices()) {
            const SurfaceIndex::Place place = SurfaceIndex::placeOf(mesh.latticePoint(v));
            const auto at = std::ranges::lower_bound(m_all, place, {}, &Entry::place);
            if (at == m_all.end() || at->place != place)
                continue;
            if (mesh.color(v) != at->color)
                mesh.setColor(v, at->color);
            if (mesh.mask(v) != at->mask)
                mesh.setMask(v, at->mask);
            if (mesh.isHidden(v) != at->isHidden)
                mesh.setHidden(v, at->isHidden);
        }
    }

private:
    struct Entry
    {
        SurfaceIndex::Place place;
        Rgb color;
        std::uint8_t mask;
        bool isHidden;
    };
    std::vector<Entry> m_all;
};

/// Returns the surface, made symmetric if it is not; nothing if neither half allows it.
std::optional<TriangleMesh> withMirroredHalf(const TriangleMesh& surface, const Lattice& lattice, Symmetry plane,
                                             const JobControl& control)
{
    Mesh mesh(withoutUnusedVertices(surface), lattice);
    mesh.beginStroke();
    const bool isMirrored = isSymmetric(mesh, plane) || mirrorHalf(mesh, plane, {control.stop, {}});
    mesh.endStroke();
    return isMirrored ? std::optional(extractMesh(mesh)) : std::nullopt;
}

double volumeInside(const TriangleMesh& surface)
{
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles)
        sum += surface.points[a]
                   .cast<double>()
                   .cross(surface.points[b].cast<double>())
                   .dot(surface.points[c].cast<double>());
    return sum / 6;
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
    if (const double across = direction.stableNormalized()[axis]; std::abs(across) > rightAngle)
        direction = std::copysign(1, across) * Vec3::Unit(axis);
    else
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
    const Mesh alone(solid, lattice);
    if (isSymmetric(alone, plane))
        return solid;
    // A tube along the plane is its own image but for the diagonals of its faces, along which the union would be cut.
    if (hasImages(alone, plane)) {
        const double volume = volumeInside(solid);
        auto half = withMirroredHalf(solid, lattice, plane, control);
        if (half && std::abs(volumeInside(*half) - volume) < sameVolume * volume)
            return half;
    }
    const std::array<TriangleMesh, 2> both = {solid, mirrorImage(solid, plane)};
    const BooleanResult united = combineOn(lattice, SetOperation::Union, both, {control.stop, {}});
    if (united.mesh)
        if (auto mirrored = withMirroredHalf(*united.mesh, lattice, plane, control))
            return mirrored;
    if (!control.isCancelled())
        change.refusal = ModelRefusal::Uncut;
    return std::nullopt;
}

bool mirrorHalf(Mesh& mesh, Symmetry plane, const JobControl& control)
{
    const AttributesByPlace attributes(mesh);
    for (const Half kept : {Half::Positive, Half::Negative}) {
        ModelChange change;
        symmetrize(mesh, {plane, kept}, change, control);
        if (change.refusal != ModelRefusal::None || control.isCancelled())
            continue;
        attributes.writeTo(mesh);
        return true;
    }
    return false;
}
} // namespace core
