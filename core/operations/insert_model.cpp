// Another model becomes part of this one, as free topology adds a sphere (paper, section 3.5.1, for any solid):
//   1. check     the newcomer by itself: it must bound a solid                               mesh_check
//   2. place     beside the present model, where its file has it, or where it was asked for
//   3. touch     on one lattice for both, no face of one may meet a face of the other        self_intersection
//   4. fit       both together must be sound there and bound a solid: neither inside the other's matter  lattice_fit
//   5. write     through the mesh's gate

#include "core/operations/insert_model.h"

#include "core/analysis/self_intersection.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/geometry/morton_order.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/transform.h"

#include <algorithm>

namespace core
{
namespace
{
/// Between the present model and one that is put beside it, of the longer side of the larger one.
constexpr double gapInSizes = 0.05;
/// Farther from the origin than this, in sizes of the larger model, nothing is inserted (as with an import).
constexpr double farthestInSizes = 4;
/// Shares of the time that an insertion takes.
constexpr double afterJudging = 0.3, afterTouching = 0.6, afterFitting = 0.9;

double longest(const Box& box)
{
    return box.sizes().maxCoeff();
}

/// By how much the newcomer is moved. Beside the present model it stands on the same floor.
Vec3 offsetOf(const Insert& command, const Mesh& mesh, const Box& present, const Box& added)
{
    switch (command.place) {
    case Insert::Place::AsItIs:
        return -mesh.frame().place;
    case Insert::Place::Centre:
        return command.centre - added.center();
    case Insert::Place::Beside:
        break;
    }
    const double gap = gapInSizes * std::max(longest(present), longest(added));
    return {present.max().x() + gap - added.min().x(), present.min().y() - added.min().y(),
            present.center().z() - added.center().z()};
}

/// Both models: the present vertices by slot, then the newcomer's.
struct Both
{
    std::vector<Vec3> places;
    std::vector<Triangle> faces;
    Slot firstAdded = 0; ///< vertex
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

/// Pairs are ascending, and present faces, of which no two meet where they are, come first.
bool doTouch(const Both& both, const Lattice& lattice, const JobControl& control)
{
    const std::vector<LatticePoint> points = snappedTo(lattice, both.places);
    const IntersectionReport meeting = selfIntersections<LatticePredicates>(points, both.faces, 1000, control.stop);
    return std::ranges::any_of(meeting.pairs, [&](const FacePair& pair) {
        return pair.first < both.presentFaces && pair.second >= both.presentFaces;
    });
}

/// Faces meet, or all is well but for the nesting.
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
} // namespace

void insertModel(Mesh& mesh, const Insert& command, ModelChange& change, const JobControl& control)
{
    change.report = checkMesh(command.model, control.part(0, afterJudging));
    if (control.isCancelled())
        return;
    if (!change.report.printReady()) {
        change.refusal = ModelRefusal::Unsound;
        return;
    }
    const TriangleMesh added = withoutUnusedVertices(command.model);
    const Box present = boxOf(mesh);
    Box place = boxOf(added);
    const Vec3 offset = offsetOf(command, mesh, present, place);
    place.translate(offset);
    if (std::sqrt(place.center().squaredNorm()) > farthestInSizes * std::max(longest(present), longest(place))) {
        change.refusal = ModelRefusal::TooFar;
        return;
    }
    const Box whole = present.merged(place);
    change.refusal = refusalOf(whole);
    if (change.refusal != ModelRefusal::None)
        return;
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
} // namespace core
