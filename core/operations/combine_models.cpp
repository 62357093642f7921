// Joins, subtracts or intersects the present model and an inserted one:
//   1. fit      both models must be sound on the lattice of the result                               lattice_fit
//   2. combine  cuts both along their intersection, and keeps the pieces that bound the result       mesh_boolean
//   3. write    exchanges only the faces that differ, so that the rest of the mesh keeps its slots

#include "core/operations/combine_models.h"

#include "core/boolean/mesh_boolean.h"
#include "core/geometry/lattice_placement.h"
#include "core/geometry/morton_order.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/surgery.h"
#include "core/operations/transform.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <tuple>

namespace core
{
namespace
{
constexpr double afterSnapping = 0.2, afterCombining = 0.9; ///< progress, 0 to 1

SetOperation operationOf(Insert::Combination how)
{
    switch (how) {
    case Insert::Combination::Subtract:
        return SetOperation::Difference;
    case Insert::Combination::Intersect:
        return SetOperation::Intersection;
    default:
        return SetOperation::Union;
    }
}

/// Returns the lattice for the result. What is subtracted or intersected needs no room to be sculpted in, so the
/// present lattice is kept if it contains the other model.
Lattice latticeOf(Insert::Combination how, const Box& whole, const Lattice& present)
{
    if (how != Insert::Combination::Join && present.contains(whole.min()) && present.contains(whole.max()))
        return present;
    return latticeFor(whole, present);
}

/// Moves the points of a model, in the order of `points`, to the lattice. Returns false, with the number of faces at
/// fault in `change`, if the model is not sound there.
bool snapModel(TriangleMesh& model, const Lattice& lattice, const std::vector<Vec3>& points, ModelChange& change,
               const JobControl& control)
{
    const LatticeFit fit = fitToLattice(lattice, points, model.triangles, control);
    change.faces = fit.unsnappable;
    if (fit.unsnappable > 0)
        change.refusal = ModelRefusal::FacesMeet;
    for (std::size_t i = 0; i < model.points.size(); ++i)
        model.points[i] = lattice.toPoint(fit.points[i]);
    return change.refusal == ModelRefusal::None && !control.isCancelled();
}

/// Returns the corners of a face, the least one first.
Triangle minFirst(Triangle t)
{
    std::ranges::rotate(t, std::ranges::min_element(t));
    return t;
}

using Position = std::tuple<float, float, float>;

Position positionOf(const Vec3f& p)
{
    return {p.x(), p.y(), p.z()};
}

/// The elements of a mesh, by position and by corners.
class KnownElements
{
public:
    explicit KnownElements(const Mesh& mesh)
    {
        for (const Slot v : mesh.vertices())
            m_vertices.emplace_back(positionOf(mesh.point(v)), v);
        for (const Slot f : mesh.faces())
            m_faces.emplace_back(minFirst(mesh.corners(f)), f);
        std::ranges::sort(m_vertices);
        std::ranges::sort(m_faces);
        m_isKept.resize(m_faces.size(), false);
    }

    std::optional<Slot> vertexAt(const Vec3f& p) const
    {
        const auto found = std::ranges::lower_bound(m_vertices, positionOf(p), {}, &Vertex::first);
        return found != m_vertices.end() && found->first == positionOf(p) ? std::optional(found->second) : std::nullopt;
    }
    /// Returns whether the mesh has a face with these corners, and keeps it.
    bool keepFace(const Triangle& corners)
    {
        const auto found = std::ranges::lower_bound(m_faces, minFirst(corners), {}, &Face::first);
        if (found == m_faces.end() || found->first != minFirst(corners))
            return false;
        m_isKept[static_cast<std::size_t>(found - m_faces.begin())] = true;
        return true;
    }
    /// Returns the faces that were not kept, sorted.
    std::vector<Slot> otherFaces() const
    {
        std::vector<Slot> others;
        for (std::size_t i = 0; i < m_faces.size(); ++i) {
            if (!m_isKept[i])
                others.push_back(m_faces[i].second);
        }
        std::ranges::sort(others);
        return others;
    }

private:
    using Vertex = std::pair<Position, Slot>;
    using Face = std::pair<Triangle, Slot>;
    std::vector<Vertex> m_vertices;
    std::vector<Face> m_faces;
    std::vector<bool> m_isKept; ///< one per face of m_faces
};

/// Returns the surgery that turns the mesh into `result`.
Surgery surgeryTo(const TriangleMesh& result, const Mesh& mesh)
{
    KnownElements known(mesh);
    Surgery surgery;
    surgery.nearby = *mesh.vertices().begin();
    std::vector<Slot> corners;
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const std::optional<Slot> vertex = known.vertexAt(result.points[i]);
        corners.push_back(vertex.value_or(Surgery::newVertex(surgery.vertices.size())));
        if (!vertex)
            surgery.vertices.push_back({result.points[i], result.colors.empty() ? Rgb() : result.colors[i], noSlot, 0});
    }
    for (const auto& [a, b, c] : result.triangles) {
        const Triangle face = {corners[a], corners[b], corners[c]};
        if (!known.keepFace(face))
            surgery.faces.push_back(face);
    }
    surgery.removed = known.otherFaces();
    return surgery;
}

/// Moves the mesh's vertices to `points`, given in the order of their slots, on another lattice.
void relocate(Mesh& mesh, const Lattice& lattice, const std::vector<Vec3f>& points)
{
    std::vector<Vec3f> bySlot(mesh.slots().vertices, Vec3f::Zero());
    std::size_t next = 0;
    for (const Slot v : mesh.vertices())
        bySlot[v] = points[next++];
    mesh.relocate(lattice, bySlot);
}

void noteRefusal(const BooleanResult& result, ModelChange& change)
{
    if (result.refusal == BooleanRefusal::LeavesNothing)
        change.refusal = ModelRefusal::NothingLeft;
    else if (result.refusal == BooleanRefusal::Unresolved)
        change.refusal = ModelRefusal::Uncut;
}
} // namespace

void combineModels(Mesh& mesh, Insert::Combination how, const PlacedModel& added, ModelChange& change,
                   const JobControl& control)
{
    assert(how != Insert::Combination::Apart && how != Insert::Combination::Part);
    const Lattice lattice = latticeOf(how, added.whole, mesh.lattice());
    const bool isSameLattice = lattice == mesh.lattice();
    std::array<TriangleMesh, 2> solids = {extractMesh(mesh), added.model};
    std::vector<Vec3> points;
    for (const Vec3f& p : added.model.points)
        points.push_back(p.cast<double>() + added.offset);
    if (!snapModel(solids[1], lattice, points, change, control.part(0, afterSnapping)))
        return;
    if (!isSameLattice) {
        points.clear();
        for (const Vec3f& p : solids[0].points)
            points.push_back(p.cast<double>());
        if (!snapModel(solids[0], lattice, points, change, {control.stop, {}}))
            return;
    }
    const BooleanResult result =
        combineOn(lattice, operationOf(how), solids, control.part(afterSnapping, afterCombining));
    noteRefusal(result, change);
    if (!result.mesh || control.isCancelled())
        return;
    if (!isSameLattice)
        relocate(mesh, lattice, solids[0].points);
    const Surgery surgery = surgeryTo(inMortonOrder(*result.mesh, lattice), mesh);
    if (!surgery.removed.empty() || !surgery.faces.empty())
        mesh.replaceFaces(surgery);
}
} // namespace core
