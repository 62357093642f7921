// Transforms the whole model (core/README.md, "The lattice"):
//   1. place     compute the exact position of every vertex, in double
//   2. lattice   keep the present one if it suits the new bounding box, else choose another
//   3. fit       snap, check the whole mesh exactly, retry neighbouring lattice points          lattice_fit
//   4. write     through the mesh's gate, if the result is sound

#include "core/operations/transform.h"

#include "core/geometry/lattice_placement.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh.h"

namespace core
{
namespace
{
/// Progress after the steps of a transformation, 0 to 1.
constexpr double afterPlacing = 0.1, afterFit = 0.8;

Box boxAround(const Mesh& mesh, std::span<const Vec3> places)
{
    Box box;
    for (const Slot v : mesh.vertices())
        box.extend(places[v]);
    return box;
}

/// A transformation: the new places by slot, and whether it turns the faces over.
struct Motion
{
    std::optional<PartId> part; ///< the part that moves; nothing: all parts
    std::vector<Vec3> places;
    bool isMirrored = false;

    bool moves(PartId other) const { return !part || *part == other; }
};

template <class Map> Motion mapped(const Mesh& mesh, std::optional<PartId> part, Map map)
{
    Motion motion{part, placesOf(mesh)};
    for (const Slot v : mesh.vertices()) {
        if (motion.moves(mesh.part(v)))
            motion.places[v] = map(motion.places[v]);
    }
    return motion;
}

/// Returns the faces that must be checked: the moved ones, or all if the lattice changes. Mirrored ones are turned
/// over.
std::vector<Triangle> facesToCheck(const Mesh& mesh, const Motion& motion, const Lattice& lattice)
{
    std::vector<Triangle> faces;
    for (const Slot f : mesh.faces()) {
        const bool moves = motion.moves(mesh.partOfFace(f));
        if (!moves && lattice == mesh.lattice())
            continue;
        const auto& [a, b, c] = mesh.corners(f);
        faces.push_back(moves && motion.isMirrored ? Triangle{a, c, b} : Triangle{a, b, c});
    }
    return faces;
}

/// Does steps 2 to 4: moves the vertices on a suitable lattice, or sets `change.refusal`.
void goTo(Mesh& mesh, const Motion& motion, ModelChange& change, const JobControl& control)
{
    const std::span<const Vec3> places = motion.places;
    control.reportProgress(afterPlacing);
    const Box box = boxAround(mesh, places);
    change.refusal = refusalOf(box);
    if (change.refusal != ModelRefusal::None)
        return;
    const Lattice lattice = latticeFor(box, mesh.lattice());
    const LatticeFit fit =
        fitPartsToLattice(lattice, places, facesToCheck(mesh, motion, lattice), partsOf(mesh), control);
    if (control.isCancelled())
        return;
    control.reportProgress(afterFit);
    if (fit.unsnappable > 0) {
        change.refusal = ModelRefusal::FacesMeet;
        change.faces = fit.unsnappable;
        return;
    }
    std::vector<Vec3f> points;
    points.reserve(fit.points.size());
    for (const LatticePoint& p : fit.points)
        points.push_back(lattice.toPoint(p));
    mesh.relocate(lattice, points);
    if (motion.isMirrored)
        mesh.reverseOrientation(motion.part);
}

/// Turns the own axes of the part, or of all parts.
void turnAxes(Mesh& mesh, std::optional<PartId> part, const Eigen::Quaterniond& rotation)
{
    MeshFrame frame = mesh.frame();
    std::vector<Part> parts = frame.parts.all();
    for (Part& turned : parts) {
        if (!part || turned.id == *part)
            turned.axes = (rotation * turned.axes).normalized();
    }
    frame.parts = PartList(std::move(parts));
    mesh.setFrame(frame);
}

void setPlace(Mesh& mesh, const Vec3& place)
{
    MeshFrame frame = mesh.frame();
    frame.place = place;
    mesh.setFrame(frame);
}
} // namespace

std::vector<Vec3> placesOf(const Mesh& mesh)
{
    std::vector<Vec3> places(mesh.slots().vertices, Vec3::Zero());
    for (const Slot v : mesh.vertices())
        places[v] = mesh.point(v).cast<double>();
    return places;
}

std::vector<Triangle> liveFaces(const Mesh& mesh)
{
    std::vector<Triangle> faces;
    faces.reserve(mesh.live().faces);
    for (const Slot f : mesh.faces())
        faces.push_back(mesh.corners(f));
    return faces;
}

Box boxOf(const Mesh& mesh)
{
    return boxAround(mesh, placesOf(mesh));
}

std::vector<PartId> partsOf(const Mesh& mesh)
{
    std::vector<PartId> parts(mesh.slots().vertices);
    for (const Slot v : mesh.vertices())
        parts[v] = mesh.part(v);
    return parts;
}

double shortestEdge(const Mesh& mesh, Slot v)
{
    double shortest = std::numeric_limits<double>::infinity();
    mesh.forEachOutgoing(v, [&](Slot h) {
        shortest = std::min(shortest, (mesh.point(mesh.to(h)) - mesh.point(v)).cast<double>().norm());
    });
    return shortest;
}

ModelRefusal refusalOf(const Box& box)
{
    const double extent = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    const bool inRange = extent >= ModelLimits::minExtent && extent <= ModelLimits::maxExtent;
    return inRange ? ModelRefusal::None : ModelRefusal::TooLarge;
}

void transform(Mesh& mesh, const Move& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control)
{
    const Motion motion = mapped(mesh, part, [&](const Vec3& p) { return p + command.by; });
    if (isFarFromOrigin(boxAround(mesh, motion.places)))
        change.refusal = ModelRefusal::TooFar;
    else
        goTo(mesh, motion, change, control);
}

void transform(Mesh& mesh, const Rotate& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control)
{
    const Eigen::Matrix3d matrix = command.rotation.toRotationMatrix();
    goTo(mesh, mapped(mesh, part, [&](const Vec3& p) { return Vec3(matrix * p); }), change, control);
    if (change.refusal == ModelRefusal::None && !control.isCancelled())
        turnAxes(mesh, part, command.rotation);
}

void transform(Mesh& mesh, const Transform& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control)
{
    Motion motion{part, placesOf(mesh)};
    bool isAllFree = true, isAllFixed = true;
    for (const Slot v : mesh.vertices()) {
        if (!motion.moves(mesh.part(v)))
            continue;
        const double freedom = mesh.freedom(v);
        isAllFree = isAllFree && freedom == 1;
        isAllFixed = isAllFixed && freedom == 0;
        if (freedom > 0)
            motion.places[v] = command.placeOf(motion.places[v], freedom);
    }
    if (isAllFixed)
        change.refusal = ModelRefusal::AllMasked;
    else if (isFarFromOrigin(boxAround(mesh, motion.places)))
        change.refusal = ModelRefusal::TooFar;
    else
        goTo(mesh, motion, change, control);
    if (!isAllFree && change.refusal == ModelRefusal::FacesMeet)
        change.refusal = ModelRefusal::Folded;
    if (isAllFree && change.refusal == ModelRefusal::None && !control.isCancelled())
        turnAxes(mesh, part, command.rotation);
}

void transform(Mesh& mesh, const Scale& command, ModelChange& change, const JobControl& control)
{
    goTo(mesh, mapped(mesh, {}, [&](const Vec3& p) { return Vec3(command.factor * p); }), change, control);
    if (change.refusal != ModelRefusal::None || control.isCancelled())
        return;
    MeshFrame frame = mesh.frame();
    frame.uniformDetail *= command.factor;
    for (double& x : frame.place)
        x = mesh.lattice().snap(command.factor * x); // as a change of the file's unit would
    mesh.setFrame(frame);
}

void transform(Mesh& mesh, const Mirror& command, std::optional<PartId> part, ModelChange& change,
               const JobControl& control)
{
    Vec3 signs = Vec3::Ones();
    signs[command.axis] = -1;
    Motion motion = mapped(mesh, part, [&](const Vec3& p) { return Vec3(signs.cwiseProduct(p)); });
    motion.isMirrored = true;
    goTo(mesh, motion, change, control);
}

void transform(Mesh& mesh, const PlaceOnBed&, ModelChange& change, const JobControl& control)
{
    transform(mesh, Move{{0, -boxOf(mesh).min().y(), 0}}, {}, change, control);
    if (change.refusal == ModelRefusal::None && !control.isCancelled())
        setPlace(mesh, {mesh.frame().place.x(), 0, mesh.frame().place.z()});
}

void transform(Mesh& mesh, const Recentre&, ModelChange& change, const JobControl& control)
{
    const Vec3 middle = mesh.lattice().snap(boxOf(mesh).center()).cast<double>();
    goTo(mesh, mapped(mesh, {}, [&](const Vec3& p) { return p - middle; }), change, control);
    if (change.refusal == ModelRefusal::None && !control.isCancelled())
        setPlace(mesh, Vec3::Zero());
}
} // namespace core
