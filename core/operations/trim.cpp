// Cuts the model along a curve:
//   1. sweep      the curve through the model's depth                                            swept_outline
//   2. combine    model and solid, and its mirror image: difference or intersection              core/boolean
//   3. fit        the result to the mesh's lattice
//   4. exchange   the faces that differ; everything else keeps its slots               surface_exchange, surgery
//   5. choose     the pieces that are seen first, if only these are to go                        cut_pieces
//   6. mirror     one half of the result, if the model was exactly symmetric                   mirror_image

#include "core/operations/trim.h"

#include "core/analysis/nesting.h"
#include "core/analysis/winding_number.h"
#include "core/area/swept_outline.h"
#include "core/boolean/mesh_boolean.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/cut_pieces.h"
#include "core/operations/mirror_image.h"
#include "core/operations/surface_exchange.h"
#include "core/operations/transform.h"
#include "core/stroke/symmetry_plane.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// Progress after the boolean and after the exchange, 0 to 1.
constexpr double afterCutting = 0.7, afterExchanging = 0.8;

/// Largest difference between the volume of a split model and that of both parts, as a share of it.
constexpr double maxLost = 1e-4;

/// Returns whether the area is its own mirror image: swept along the mirror normal, or along a curve that runs back as
/// the image of its way there.
bool isOwnImage(const ViewArea& area)
{
    const Vec3 mirrorNormal = planeNormal(area.symmetry);
    const Vec3 across = area.direction - mirrorNormal.dot(area.direction) * mirrorNormal;
    if (!area.eye && across.isZero(0))
        return true;
    if (mirrorNormal.dot(area.direction) != 0 || (area.eye && mirrorNormal.dot(*area.eye) != 0))
        return false;
    const std::size_t corners = area.outline.size();
    for (std::size_t i = 0; i < corners; ++i) {
        if (area.outline[i] != mirrored(area.outline[corners - 1 - i], area.symmetry))
            return false;
    }
    return true;
}

ViewArea mirrored(ViewArea area)
{
    for (Vec3& corner : area.outline)
        corner = mirrored(corner, area.symmetry);
    area.direction = mirrored(area.direction, area.symmetry);
    if (area.eye)
        area.eye = mirrored(*area.eye, area.symmetry);
    return area;
}

/// The solids that an area sweeps: its own, and with symmetry that of its mirror image.
struct SweptSolids
{
    bool hasArea = false;
    std::vector<TriangleMesh> solids; ///< without those that are beside the model
};

SweptSolids sweptSolids(const ViewArea& area, const Mesh& mesh)
{
    SweptSolids swept;
    const auto add = [&](SweptOutline&& one) {
        swept.hasArea = one.hasArea;
        if (!one.solid.triangles.empty())
            swept.solids.push_back(std::move(one.solid));
    };
    add(sweptOutline(area, mesh));
    if (!swept.hasArea || area.symmetry == Symmetry::None || isOwnImage(area))
        return swept;
    if (!isSymmetric(mesh, area.symmetry))
        add(sweptOutline(mirrored(area), mesh));
    else if (!swept.solids.empty())
        swept.solids.push_back(mirrorImage(swept.solids.front(), area.symmetry));
    return swept;
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

BooleanResult cut(const Mesh& mesh, std::vector<TriangleMesh> solids, const Trim& command, const JobControl& control)
{
    if (const auto color = colorOfCut(command, mesh); color && *color != Rgb()) {
        for (TriangleMesh& solid : solids)
            solid.colors.assign(solid.points.size(), *color);
    }
    TriangleMesh model = extractMesh(mesh);
    model.masks.clear();
    solids.insert(solids.begin(), std::move(model));
    if (command.area.side == ViewArea::Side::Inside)
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

/// Returns the volume that the mesh encloses.
double volumeOf(const TriangleMesh& mesh)
{
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 from = mesh.points.front().cast<double>();
        const auto at = [&](Slot v) -> Vec3 { return mesh.points[v].cast<double>() - from; };
        sum += at(a).cross(at(b)).dot(at(c)) / 6;
    }
    return sum;
}

/// Returns the pieces of a solid that are no longer in the mesh. A piece is judged just below its largest face.
TriangleMesh withoutKept(const TriangleMesh& solid, const Mesh& mesh)
{
    constexpr double below = 16; // lattice units: more than rounding moves a cut
    const WindingNumber kept(extractMesh(mesh));
    const Components pieces = solidPiecesOf(solid.points, solid.triangles);
    std::vector<double> largest(pieces.count); // area of the largest face, twice
    std::vector<bool> isKept(pieces.count);
    for (std::size_t f = 0; f < solid.triangles.size(); ++f) {
        const auto at = [&](std::size_t i) -> Vec3 { return solid.points[solid.triangles[f][i]].cast<double>(); };
        const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
        const Slot piece = pieces.ofFace[f];
        if (normal.norm() <= largest[piece])
            continue;
        largest[piece] = normal.norm();
        const Vec3 inside = (at(0) + at(1) + at(2)) / 3 - below * mesh.lattice().unit() * normal.normalized();
        isKept[piece] = kept.at(inside) > 0.5;
    }
    TriangleMesh gone = solid;
    gone.triangles.clear();
    for (std::size_t f = 0; f < solid.triangles.size(); ++f) {
        if (!isKept[pieces.ofFace[f]])
            gone.triangles.push_back(solid.triangles[f]);
    }
    return withoutUnusedVertices(gone);
}

/// Returns the exchange of faces that makes the cut; empty if it changes nothing. Sets change.refusal if there is no
/// sound one.
Surgery surgeryOf(const Trim& command, const Mesh& mesh, ModelChange& change, const JobControl& control)
{
    SweptSolids swept = sweptSolids(command.area, mesh);
    const bool isBeside = swept.solids.empty();
    const bool takesAll = command.area.side == ViewArea::Side::Outside;
    if (!swept.hasArea || (isBeside && takesAll && !command.area.isFrontOnly))
        change.refusal = swept.hasArea ? ModelRefusal::NothingLeft : ModelRefusal::NoOutline;
    if (change.refusal != ModelRefusal::None || (isBeside && !takesAll))
        return {};
    TriangleMesh after;
    if (!isBeside) {
        BooleanResult result = cut(mesh, std::move(swept.solids), command, control);
        const bool isEmpty = result.refusal == BooleanRefusal::LeavesNothing;
        if (control.isCancelled())
            return {};
        if (!result.mesh && !(isEmpty && command.area.isFrontOnly))
            change.refusal = isEmpty ? ModelRefusal::NothingLeft : ModelRefusal::NoCut;
        if (change.refusal != ModelRefusal::None)
            return {};
        if (result.mesh)
            after = withoutUnusedVertices(*result.mesh);
    }
    const auto places = latticePlaces(after, mesh.lattice(), {control.stop, {}});
    if (control.isCancelled())
        return {};
    Surgery surgery = places ? exchangeWith(after, *places, mesh) : Surgery();
    if (!places || !isSurgeryOk(mesh, surgery))
        change.refusal = ModelRefusal::NoCut;
    return surgery;
}

/// Restricts the exchange to the pieces that are seen first.
void keepFirst(Surgery& surgery, const Trim& command, const Mesh& mesh, ModelChange& change)
{
    const CutPieces pieces(mesh, surgery);
    Surgery first = pieces.taking(pieces.seenFirst(command.area));
    if (first.faces.empty() && first.removed.size() == mesh.live().faces)
        change.refusal = ModelRefusal::NothingLeft;
    else if (!isSurgeryOk(mesh, first))
        change.refusal = ModelRefusal::NoCut;
    surgery = std::move(first);
}
/// Does what trim() does. Returns whether that changes the mesh.
bool cutAway(Mesh& mesh, const Trim& command, ModelChange& change, const JobControl& control)
{
    Surgery surgery = surgeryOf(command, mesh, change, control.part(0, afterCutting));
    if (control.isCancelled() || change.refusal != ModelRefusal::None)
        return false;
    if (surgery.removed.empty() && surgery.faces.empty())
        return false;
    if (command.area.isFrontOnly)
        keepFirst(surgery, command, mesh, change);
    if (change.refusal != ModelRefusal::None)
        return false;
    const Symmetry plane = command.area.symmetry;
    const bool wasSymmetric = plane != Symmetry::None && isSymmetric(mesh, plane);
    const Mesh::Mark mark = mesh.mark();
    mesh.replaceFaces(surgery);
    control.reportProgress(afterExchanging);
    if (wasSymmetric && !isSymmetric(mesh, plane) && !mirrorHalf(mesh, plane, control.part(afterExchanging, 1)))
        change.refusal = control.isCancelled() ? ModelRefusal::None : ModelRefusal::NoCut;
    if (change.refusal != ModelRefusal::None || control.isCancelled())
        mesh.rollback(mark);
    return change.refusal == ModelRefusal::None && !control.isCancelled();
}
} // namespace

void trim(Mesh& mesh, const Trim& command, ModelChange& change, const JobControl& control)
{
    cutAway(mesh, command, change, control);
}

std::optional<TriangleMesh> split(Mesh& mesh, const Trim& command, ModelChange& change, const JobControl& control)
{
    Mesh other = mesh;
    const double whole = volumeOf(extractMesh(mesh));
    const bool isDivided = cutAway(mesh, command, change, control.part(0, 0.5));
    if (change.refusal == ModelRefusal::NothingLeft)
        change.refusal = ModelRefusal::None;
    if (!isDivided)
        return std::nullopt;
    Trim opposite = command;
    opposite.area.side = command.area.side == ViewArea::Side::Inside ? ViewArea::Side::Outside : ViewArea::Side::Inside;
    opposite.area.isFrontOnly = false;
    trim(other, opposite, change, control.part(0.5, 1));
    if (change.refusal != ModelRefusal::None || control.isCancelled())
        return std::nullopt;
    TriangleMesh taken = extractMesh(other);
    if (command.area.isFrontOnly)
        taken = withoutKept(taken, mesh);
    // the two cuts are made one by one, so they might choose different pieces
    if (std::abs(volumeOf(extractMesh(mesh)) + volumeOf(taken) - whole) > maxLost * whole) {
        change.refusal = ModelRefusal::NoCut;
        return std::nullopt;
    }
    return taken;
}
} // namespace core
