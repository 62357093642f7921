// Cuts the model along a curve:
//   1. sweep      the curve through the model's depth                                            swept_outline
//   2. combine    model and solid, and its mirror image: difference or intersection              core/boolean
//   3. fit        the result to the mesh's lattice
//   4. exchange   the faces that differ; everything else keeps its slots                         surgery
//   5. mirror     one half of the result, if the model was exactly symmetric                     symmetrize

#include "core/operations/trim.h"

#include "core/boolean/mesh_boolean.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/swept_outline.h"
#include "core/operations/symmetrize.h"
#include "core/operations/transform.h"

#include <algorithm>
#include <limits>

namespace core
{
namespace
{
/// Progress after the boolean and after the exchange, 0 to 1.
constexpr double afterCombining = 0.7, afterExchanging = 0.8;

/// Largest distance, in lattice units along an axis, by which combine() moves the corners of faces that it cuts: its
/// lattice has to reach around the swept solid and may be four times coarser.
constexpr int farthestMoved = 2;

using Place = std::array<int, 3>;

Place placeOf(const LatticePoint& p)
{
    return {p.x(), p.y(), p.z()};
}

/// Finds vertices by their places and faces by their corners.
class SurfaceIndex
{
public:
    explicit SurfaceIndex(const Mesh& mesh);

    Slot vertexAt(const Place& place) const { return found(m_vertices, place); }
    /// Returns the nearest vertex whose coordinates differ by at most `farthestMoved`, or noSlot.
    Slot vertexNear(const Place& place) const;
    /// Returns the face with these corners in this cyclic order, or noSlot.
    Slot faceOf(const Triangle& corners) const { return found(m_faces, turned(corners)); }

private:
    template <class Key> using Table = std::vector<std::pair<Key, Slot>>;

    template <class Key> static Slot found(const Table<Key>& table, const Key& key)
    {
        const auto at = std::ranges::lower_bound(table, key, {}, &std::pair<Key, Slot>::first);
        return at != table.end() && at->first == key ? at->second : noSlot;
    }
    static Triangle turned(Triangle corners)
    {
        std::ranges::rotate(corners, std::ranges::min_element(corners));
        return corners;
    }

    Table<Place> m_vertices;
    Table<Triangle> m_faces;
};

SurfaceIndex::SurfaceIndex(const Mesh& mesh)
{
    for (const Slot v : mesh.vertices())
        m_vertices.emplace_back(placeOf(mesh.latticePoint(v)), v);
    for (const Slot f : mesh.faces())
        m_faces.emplace_back(turned(mesh.corners(f)), f);
    std::ranges::sort(m_vertices);
    std::ranges::sort(m_faces);
}

Slot SurfaceIndex::vertexNear(const Place& place) const
{
    Slot nearest = noSlot;
    int least = std::numeric_limits<int>::max();
    for (int x = -farthestMoved; x <= farthestMoved; ++x) {
        for (int y = -farthestMoved; y <= farthestMoved; ++y) {
            for (int z = -farthestMoved; z <= farthestMoved; ++z) {
                const int away = x * x + y * y + z * z;
                if (away >= least)
                    continue;
                if (const Slot v = vertexAt({place[0] + x, place[1] + y, place[2] + z}); v != noSlot) {
                    nearest = v;
                    least = away;
                }
            }
        }
    }
    return nearest;
}

int mirrorAxis(Symmetry plane)
{
    return static_cast<int>(plane) - static_cast<int>(Symmetry::X);
}

/// Returns whether each face has a mirror image, bit for bit.
bool isSymmetric(const Mesh& mesh, Symmetry plane)
{
    const SurfaceIndex index(mesh);
    const auto imageOf = [&](Slot v) {
        Place place = placeOf(mesh.latticePoint(v));
        place[static_cast<std::size_t>(mirrorAxis(plane))] *= -1;
        return index.vertexAt(place);
    };
    return std::ranges::all_of(mesh.faces(), [&](Slot f) {
        const auto [a, b, c] = mesh.corners(f);
        return index.faceOf({imageOf(a), imageOf(c), imageOf(b)}) != noSlot;
    });
}

TriangleMesh mirrored(TriangleMesh mesh, Symmetry plane)
{
    for (Vec3f& p : mesh.points)
        p[mirrorAxis(plane)] = 0 - p[mirrorAxis(plane)];
    for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

/// Returns the colour of the cut: the command's, or that of the model if it has only one.
std::optional<Rgb> colorOfCut(const Trim& command, const Mesh& mesh)
{
    if (command.color)
        return command.color;
    const Rgb first = mesh.color(*mesh.vertices().begin());
    const bool isOne = std::ranges::all_of(mesh.vertices(), [&](Slot v) { return mesh.color(v) == first; });
    return isOne ? std::optional(first) : std::nullopt;
}

BooleanResult cut(const Mesh& mesh, TriangleMesh solid, const Trim& command, const JobControl& control)
{
    if (const auto color = colorOfCut(command, mesh); color && *color != Rgb())
        solid.colors.assign(solid.points.size(), *color);
    TriangleMesh model = extractMesh(mesh);
    model.masks.clear();
    std::vector<TriangleMesh> solids{std::move(model), std::move(solid)};
    if (command.symmetry != Symmetry::None)
        solids.push_back(mirrored(solids.back(), command.symmetry));
    if (command.remove == Trim::Remove::Inside)
        return combine(SetOperation::Difference, solids, control);
    if (solids.size() > 2) {
        BooleanResult both = combine(SetOperation::Union, std::span(solids).subspan(1), {control.stop, {}});
        if (!both.mesh)
            return both;
        solids.resize(2);
        solids.back() = std::move(*both.mesh);
    }
    return combine(SetOperation::Intersection, solids, control);
}

/// Returns the points on the lattice; nothing if they cannot be placed there soundly.
std::optional<std::vector<LatticePoint>> latticePlaces(const TriangleMesh& model, const Lattice& lattice,
                                                       const JobControl& control)
{
    std::vector<Vec3> places;
    for (const Vec3f& p : model.points)
        places.push_back(p.cast<double>());
    if (!std::ranges::all_of(places, [&](const Vec3& p) { return lattice.contains(p); }))
        return std::nullopt;
    if (std::ranges::all_of(model.points, [&](const Vec3f& p) { return lattice.isOnLattice(p); }))
        return snappedTo(lattice, places);
    LatticeFit fit = fitToLattice(lattice, places, model.triangles, control);
    return fit.unsnappable == 0 ? std::optional(std::move(fit.points)) : std::nullopt;
}

/// Returns the exchange of faces that turns the mesh into `after`.
Surgery exchange(const Mesh& mesh, const TriangleMesh& after, std::span<const LatticePoint> places)
{
    const SurfaceIndex index(mesh);
    Surgery surgery;
    surgery.near = *mesh.vertices().begin();
    std::vector<Slot> corners;
    for (std::size_t i = 0; i < places.size(); ++i) {
        corners.push_back(index.vertexAt(placeOf(places[i])));
        if (corners.back() != noSlot)
            continue;
        corners.back() = Surgery::newVertex(surgery.vertices.size());
        const Rgb color = after.colors.empty() ? Rgb() : after.colors[i];
        const Slot moved = index.vertexNear(placeOf(places[i]));
        const std::uint8_t mask = moved == noSlot ? std::uint8_t(0) : mesh.mask(moved);
        surgery.vertices.push_back({mesh.lattice().toPoint(places[i]), color, noSlot, mask});
    }
    std::vector<bool> isKept(mesh.slots().faces, false);
    for (const auto& [a, b, c] : after.triangles) {
        const Triangle face = {corners[a], corners[b], corners[c]};
        if (const Slot same = index.faceOf(face); same != noSlot)
            isKept[same] = true;
        else
            surgery.faces.push_back(face);
    }
    std::ranges::copy_if(mesh.faces(), std::back_inserter(surgery.removed), [&](Slot f) { return !isKept[f]; });
    return surgery;
}

/// Makes the result of a cut exactly symmetric again.
void mirrorHalf(Mesh& mesh, Symmetry plane, ModelChange& change, const JobControl& control)
{
    for (const Half kept : {Half::Positive, Half::Negative}) {
        change.refusal = ModelRefusal::None;
        symmetrize(mesh, {plane, kept}, change, control);
        if (change.refusal == ModelRefusal::None)
            return;
    }
    change.refusal = ModelRefusal::NoCut;
}
} // namespace

void trim(Mesh& mesh, const Trim& command, ModelChange& change, const JobControl& control)
{
    SweptOutline swept = sweptOutline(command, mesh);
    const bool isBeside = swept.solid.triangles.empty();
    if (!swept.hasArea || (isBeside && command.remove == Trim::Remove::Outside))
        change.refusal = swept.hasArea ? ModelRefusal::NothingLeft : ModelRefusal::NoOutline;
    if (isBeside || !swept.hasArea)
        return;
    const BooleanResult result = cut(mesh, std::move(swept.solid), command, control.part(0, afterCombining));
    if (control.isCancelled())
        return;
    if (!result.mesh) {
        change.refusal =
            result.refusal == BooleanRefusal::LeavesNothing ? ModelRefusal::NothingLeft : ModelRefusal::NoCut;
        return;
    }
    const TriangleMesh after = withoutUnusedVertices(*result.mesh);
    const auto places = latticePlaces(after, mesh.lattice(), {control.stop, {}});
    if (control.isCancelled())
        return;
    const Surgery surgery = places ? exchange(mesh, after, *places) : Surgery();
    if (!places || !isSurgeryOk(mesh, surgery)) {
        change.refusal = ModelRefusal::NoCut;
        return;
    }
    if (surgery.removed.empty() && surgery.faces.empty())
        return;
    const bool wasSymmetric = command.symmetry != Symmetry::None && isSymmetric(mesh, command.symmetry);
    const Mesh::Mark mark = mesh.mark();
    mesh.replaceFaces(surgery);
    control.reportProgress(afterExchanging);
    if (wasSymmetric && !isSymmetric(mesh, command.symmetry))
        mirrorHalf(mesh, command.symmetry, change, control.part(afterExchanging, 1));
    if (change.refusal != ModelRefusal::None)
        mesh.rollback(mark);
}

/// Sweeps a rectangle along the plane. One of its sides is on the plane.
Trim trimBeyond(const Vec3& point, const Vec3& normal, const Box& box)
{
    const Vec3 up = normal.stableNormalized(), along = up.unitOrthogonal(), aside = up.cross(along);
    const double away = (box.center() - point).dot(up);
    const double reach = 2 * (box.diagonal().norm() + std::abs(away));
    const Vec3 center = box.center() - away * up;
    Trim trim;
    trim.direction = along;
    trim.outline = {center - reach * aside, center + reach * aside, center + reach * (aside + up),
                    center + reach * (up - aside)};
    return trim;
}
} // namespace core
