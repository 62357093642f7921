// Inserts another model, as free topology adds a sphere (paper, section 3.5.1), for any solid:
//   1. check     the inserted model alone: it must bound a solid                                    mesh_check
//   2. place     beside the present model, where its own file puts it, or at a requested point
// If it is combined with the present model, combine_models does the rest. If it becomes a part, it need only fit on the
// lattice. Else:
//   3. touch     no face of one model may meet a face of the other, on a common lattice             self_intersection
//   4. fit       the combined mesh must be sound on the lattice; neither model inside the other's material  lattice_fit
//   5. write     through the mesh's gate

#include "core/operations/insert_model.h"

#include "core/analysis/self_intersection.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/geometry/morton_order.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/combine_models.h"
#include "core/operations/detached_part.h"
#include "core/operations/mirror_image.h"
#include "core/operations/surface_exchange.h"
#include "core/operations/transform.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace core
{
namespace
{
/// Gap between the present model and one placed beside it, as a fraction of the longest side of the larger model.
constexpr double gapInSizes = 0.05;
/// Largest distance of an inserted model's centre from the origin, in longest sides of the larger model, as for
/// imports.
constexpr double farthestInSizes = 4;
/// Progress after steps 1, 3 and 4 of an insertion, 0 to 1.
constexpr double afterJudging = 0.3, afterTouching = 0.6, afterFitting = 0.9;

double longest(const Box& box)
{
    return box.sizes().maxCoeff();
}

/// Returns the model to insert; nothing, with the reason in `change`, if it is a primitive that cannot be made.
std::optional<TriangleMesh> modelOf(const Insert& command, ModelChange& change, const JobControl& control)
{
    if (!command.primitive)
        return command.model;
    change.primitive = makePrimitive(*command.primitive, control);
    if (!change.primitive.mesh)
        change.refusal = ModelRefusal::Primitive;
    return std::exchange(change.primitive.mesh, std::nullopt);
}

bool isTube(const Insert& command)
{
    return command.primitive && command.primitive->kind == Primitive::Kind::Tube;
}

/// Returns the vector by which the inserted model is moved. Beside the present model it is set on the same floor (least
/// y).
Vec3 offsetOf(const Insert& command, const Mesh& mesh, const Box& present, const Box& added)
{
    switch (command.place) {
    case Insert::Place::AsItIs:
        return isTube(command) ? Vec3(Vec3::Zero()) : Vec3(-mesh.frame().place);
    case Insert::Place::Centre:
        return command.primitive && !isTube(command) ? command.centre : Vec3(command.centre - added.center());
    case Insert::Place::Floor:
        return command.centre - Vec3(added.center().x(), added.min().y(), added.center().z());
    case Insert::Place::Beside:
        break;
    }
    const double gap = gapInSizes * std::max(longest(present), longest(added));
    return {present.max().x() + gap - added.min().x(), present.min().y() - added.min().y(),
            present.center().z() - added.center().z()};
}

/// The vertices of both models: the present ones by slot, then the inserted ones.
struct Both
{
    std::vector<Vec3> places;
    std::vector<Triangle> faces;
    Slot firstAdded = 0; ///< index of the first inserted vertex
    Slot presentFaces = 0;
};

Both together(const Mesh& mesh, const TriangleMesh& added, const Vec3& offset)
{
    Both both = {placesOf(mesh), liveFaces(mesh), mesh.slots().vertices, mesh.live().faces};
    for (const Vec3f& p : added.points)
        both.places.push_back(p.cast<double>() + offset);
    for (const auto& [a, b, c] : added.triangles)
        both.faces.push_back({a + both.firstAdded, b + both.firstAdded, c + both.firstAdded});
    return both;
}

/// Returns true if a face of one model meets a face of the other. Two present faces never meet and the smallest pairs
/// are kept, so the limit of 1000 pairs cannot hide a pair of a present and an inserted face.
bool doTouch(const Both& both, const Lattice& lattice, const JobControl& control)
{
    const std::vector<LatticePoint> points = snappedTo(lattice, both.places);
    const IntersectionReport meeting = selfIntersections<LatticePredicates>(points, both.faces, 1000, control.stop);
    return std::ranges::any_of(meeting.pairs, [&](const FacePair& pair) {
        return pair.first < both.presentFaces && pair.second >= both.presentFaces;
    });
}

/// Returns why the combined mesh was refused: faces meet, or, if every face is at fault, one model is inside the other.
ModelRefusal refusalOfFit(const LatticeFit& fit, const Both& both)
{
    if (fit.unsnappable == 0)
        return ModelRefusal::None;
    return fit.unsnappable == both.faces.size() ? ModelRefusal::Inside : ModelRefusal::FacesMeet;
}

void write(Mesh& mesh, const Lattice& lattice, const LatticeFit& fit, TriangleMesh added)
{
    std::vector<Vec3f> points;
    for (const LatticePoint& p : fit.points)
        points.push_back(lattice.toPoint(p));
    const auto firstAdded = points.begin() + static_cast<std::ptrdiff_t>(mesh.slots().vertices);
    added.points.assign(firstAdded, points.end());
    points.erase(firstAdded, points.end());
    mesh.relocate(lattice, points);
    mesh.replaceFaces(additionOf(inMortonOrder(added, lattice), *mesh.vertices().begin()));
}

void insertApart(Mesh& mesh, const TriangleMesh& added, const Vec3& offset, const Box& whole, ModelChange& change,
                 const JobControl& control)
{
    const Both both = together(mesh, added, offset);
    const Lattice lattice = latticeFor(whole, mesh.lattice());
    if (doTouch(both, lattice, control)) {
        change.refusal = ModelRefusal::Touching;
        return;
    }
    control.reportProgress(afterTouching);
    const LatticeFit fit = fitToLattice(lattice, both.places, both.faces, control);
    control.reportProgress(afterFitting);
    change.refusal = refusalOfFit(fit, both);
    change.faces = fit.unsnappable;
    if (change.refusal == ModelRefusal::None && !control.isCancelled())
        write(mesh, lattice, fit, added);
}

/// Adds the inserted model as a part, and moves all parts to another lattice if it needs one.
void insertAsPart(Mesh& mesh, const std::string& name, const PlacedModel& placed, ModelChange& change,
                  const JobControl& control)
{
    const Lattice lattice = latticeFor(placed.whole, mesh.lattice());
    std::vector<Vec3> places;
    for (const Vec3f& p : placed.model.points)
        places.push_back(p.cast<double>() + placed.offset);
    const LatticeFit fit = fitToLattice(lattice, places, placed.model.triangles, control);
    change.faces = fit.unsnappable;
    if (fit.unsnappable > 0)
        change.refusal = ModelRefusal::FacesMeet;
    control.reportProgress(afterTouching);
    if (change.refusal == ModelRefusal::None && !control.isCancelled() && lattice != mesh.lattice())
        relocateParts(mesh, lattice, change, control);
    if (change.refusal != ModelRefusal::None || control.isCancelled())
        return;
    TriangleMesh surface = placed.model;
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        surface.points[i] = lattice.toPoint(fit.points[i]);
    MeshFrame frame = mesh.frame();
    const PartId id = frame.parts.freeId();
    replacePart(mesh, id, surface);
    frame.parts = frame.parts.with({id, frame.parts.freeName(name), true, false, std::nullopt});
    mesh.setFrame(frame);
    change.addedPart = id;
}
/// Returns the box around both boxes. Sets change.refusal if the added one is too far from the origin, or the result
/// too large.
Box wholeBox(const Box& present, const Box& added, ModelChange& change)
{
    const Box whole = present.merged(added);
    const double reach = std::sqrt(added.center().squaredNorm());
    change.refusal =
        reach > farthestInSizes * std::max(longest(present), longest(added)) ? ModelRefusal::TooFar : refusalOf(whole);
    return whole;
}

/// Moves the solid by `offset`, which becomes zero, and unites it with its mirror image. Returns false if it cannot.
bool addImage(TriangleMesh& solid, Vec3& offset, const Lattice& lattice, Symmetry plane, ModelChange& change,
              const JobControl& control)
{
    for (Vec3f& p : solid.points)
        p = (p.cast<double>() + offset).cast<float>();
    offset.setZero();
    auto both = withMirrorImage(std::move(solid), lattice, plane, change, control);
    solid = std::move(both).value_or(TriangleMesh());
    return !solid.triangles.empty() && !control.isCancelled();
}
} // namespace

void insertModel(Mesh& mesh, const Insert& command, ModelChange& change, const JobControl& control)
{
    const bool becomesPart = command.combination == Insert::Combination::Part;
    if (becomesPart && mesh.frame().parts.size() == PartList::maxParts) {
        change.refusal = ModelRefusal::TooManyParts;
        return;
    }
    const auto made = modelOf(command, change, control.part(0, 0));
    if (!made)
        return;
    change.report = checkMesh(*made, control.part(0, afterJudging));
    if (control.isCancelled())
        return;
    if (!change.report.printReady()) {
        change.refusal = ModelRefusal::Unsound;
        return;
    }
    TriangleMesh added = withoutUnusedVertices(*made);
    const Box present = boxOf(mesh);
    Vec3 offset = offsetOf(command, mesh, present, boxOf(added));
    Box place = boxOf(added).translate(offset);
    Box whole = wholeBox(present, place, change);
    if (change.refusal != ModelRefusal::None)
        return;
    const Symmetry plane = command.symmetry;
    if (plane != Symmetry::None) {
        whole.extend(mirrorImage(place, plane));
        change.refusal = refusalOf(whole);
        if (change.refusal != ModelRefusal::None ||
            !addImage(added, offset, latticeFor(whole, mesh.lattice()), plane, change, control))
            return;
    }
    const bool wasSymmetric = plane != Symmetry::None && !becomesPart && isSymmetric(mesh, plane);
    if (command.combination == Insert::Combination::Apart)
        insertApart(mesh, added, offset, whole, change, control);
    else if (becomesPart)
        insertAsPart(mesh, command.name, {added, offset, whole}, change, control);
    else
        combineModels(mesh, command.combination, {added, offset, whole}, change, control.part(afterJudging, 1));
    const bool isMade = change.refusal == ModelRefusal::None && !control.isCancelled();
    if (isMade && wasSymmetric && !isSymmetric(mesh, plane) && !mirrorHalf(mesh, plane, {control.stop, {}}) &&
        !control.isCancelled())
        change.refusal = ModelRefusal::Uncut;
}
} // namespace core
