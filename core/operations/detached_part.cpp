#include "core/operations/detached_part.h"

#include "core/geometry/lattice_placement.h"
#include "core/geometry/morton_order.h"
#include "core/mesh/lattice_fit.h"
#include "core/mesh/mesh_builder.h"
#include "core/operations/transform.h"

#include <algorithm>
#include <array>

namespace core
{
namespace
{
std::vector<Slot> verticesOf(const Mesh& mesh, PartId part)
{
    std::vector<Slot> vertices;
    std::ranges::copy_if(mesh.vertices(), std::back_inserter(vertices), [&](Slot v) { return mesh.part(v) == part; });
    return vertices;
}

std::vector<Slot> facesOf(const Mesh& mesh, PartId part)
{
    std::vector<Slot> faces;
    std::ranges::copy_if(mesh.faces(), std::back_inserter(faces), [&](Slot f) { return mesh.partOfFace(f) == part; });
    return faces;
}

} // namespace

void relocateParts(Mesh& mesh, const Lattice& lattice, ModelChange& change, const JobControl& control)
{
    const std::vector<Vec3> places = placesOf(mesh);
    const LatticeFit fit = fitPartsToLattice(lattice, places, liveFaces(mesh), partsOf(mesh), control);
    if (fit.unsnappable > 0) {
        change.refusal = ModelRefusal::FacesMeet;
        change.faces = fit.unsnappable;
        return;
    }
    std::vector<Vec3f> points;
    for (const LatticePoint& p : fit.points)
        points.push_back(lattice.toPoint(p));
    mesh.relocate(lattice, points);
}

DetachedPart::DetachedPart(const Mesh& whole, PartId part) : m_part(part), m_vertices(verticesOf(whole, part))
{
    const TriangleMesh surface = surfaceOf(whole, part);
    m_faces = surface.triangles;
    m_mesh = std::make_unique<Mesh>(surface, whole.lattice());
    MeshFrame frame = whole.frame();
    frame.parts = {};
    m_mesh->beginStroke();
    m_mesh->setFrame(frame);
    for (Slot i = 0; i < m_vertices.size(); ++i) {
        if (whole.isHidden(m_vertices[i]))
            m_mesh->setHidden(i, true);
    }
    m_mesh->endStroke();
}

bool DetachedPart::hasSameFaces() const
{
    if (m_mesh->slots() != m_mesh->live() || m_mesh->live().faces != m_faces.size())
        return false;
    return std::ranges::all_of(m_mesh->faces(), [&](Slot f) { return m_mesh->corners(f) == m_faces[f]; });
}

void DetachedPart::writeVertices(Mesh& whole) const
{
    for (Slot i = 0; i < m_vertices.size(); ++i) {
        const Slot v = m_vertices[i];
        if (whole.point(v) != m_mesh->point(i))
            whole.setPoint(v, m_mesh->point(i));
        if (whole.color(v) != m_mesh->color(i))
            whole.setColor(v, m_mesh->color(i));
        if (whole.mask(v) != m_mesh->mask(i))
            whole.setMask(v, m_mesh->mask(i));
    }
}

/// Hides the vertices of the part that are hidden in the detached mesh. `points`: their places in the whole mesh, in
/// the order of the detached mesh's vertices.
void DetachedPart::hideAgain(Mesh& whole, const std::vector<Vec3f>& points) const
{
    std::vector<Vec3f> hidden;
    std::size_t next = 0;
    for (const Slot v : m_mesh->vertices()) {
        if (m_mesh->isHidden(v))
            hidden.push_back(points[next]);
        ++next;
    }
    hideAt(whole, m_part, hidden);
}

void DetachedPart::putBack(Mesh& whole, ModelChange& change, const JobControl& control)
{
    if (hasSameFaces() && m_mesh->lattice() == whole.lattice()) {
        writeVertices(whole);
    } else {
        TriangleMesh surface = extractMesh(*m_mesh);
        const Lattice lattice = latticeWith(whole, m_part, surface);
        if (m_mesh->lattice() != lattice && !fitSurface(surface, lattice, change, control))
            return;
        if (whole.lattice() != lattice) {
            replacePart(whole, m_part, {});
            relocateParts(whole, lattice, change, control);
            if (change.refusal != ModelRefusal::None)
                return;
        }
        replacePart(whole, m_part, surface);
        hideAgain(whole, surface.points);
    }
    MeshFrame frame = whole.frame();
    frame.uniformDetail = m_mesh->uniformDetail();
    whole.setFrame(frame);
}

bool hasFaces(const Mesh& mesh, PartId part)
{
    return std::ranges::any_of(mesh.vertices(), [&](Slot v) { return mesh.part(v) == part; });
}

void hideAt(Mesh& mesh, PartId part, const std::vector<Vec3f>& places)
{
    using Place = std::array<float, 3>;
    const auto placeOf = [](const Vec3f& p) { return Place{p.x(), p.y(), p.z()}; };
    std::vector<Place> hidden;
    std::ranges::transform(places, std::back_inserter(hidden), placeOf);
    std::ranges::sort(hidden);
    for (const Slot v : hidden.empty() ? std::vector<Slot>() : verticesOf(mesh, part)) {
        if (std::ranges::binary_search(hidden, placeOf(mesh.point(v))))
            mesh.setHidden(v, true);
    }
}

TriangleMesh surfaceOf(const Mesh& mesh, PartId part)
{
    TriangleMesh surface;
    std::vector<Slot> newIndex(mesh.slots().vertices, noSlot);
    for (const Slot v : verticesOf(mesh, part)) {
        newIndex[v] = static_cast<Slot>(surface.points.size());
        surface.points.push_back(mesh.point(v));
        surface.colors.push_back(mesh.color(v));
        surface.masks.push_back(mesh.mask(v));
    }
    for (const Slot f : facesOf(mesh, part)) {
        const auto& [a, b, c] = mesh.corners(f);
        surface.triangles.push_back({newIndex[a], newIndex[b], newIndex[c]});
    }
    return surface;
}

void replacePart(Mesh& mesh, PartId part, const TriangleMesh& surface)
{
    const std::vector<Slot> before = verticesOf(mesh, part);
    if (before.empty() && surface.triangles.empty())
        return;
    Surgery surgery;
    if (!surface.triangles.empty())
        surgery = additionOf(inMortonOrder(surface, mesh.lattice()), 0);
    surgery.nearby = before.empty() ? *mesh.vertices().begin() : before.front();
    surgery.removed = facesOf(mesh, part);
    for (const Slot v : mesh.replaceFaces(surgery)) {
        if (mesh.part(v) != part)
            mesh.setPart(v, part);
    }
}

Lattice latticeWith(const Mesh& mesh, PartId part, const TriangleMesh& surface)
{
    Box box;
    for (const Slot v : mesh.vertices()) {
        if (mesh.part(v) != part)
            box.extend(mesh.point(v).cast<double>());
    }
    for (const Vec3f& p : surface.points)
        box.extend(p.cast<double>());
    return latticeFor(box, mesh.lattice());
}

bool fitSurface(TriangleMesh& surface, const Lattice& lattice, ModelChange& change, const JobControl& control)
{
    if (std::ranges::all_of(surface.points, [&](const Vec3f& p) { return lattice.isOnLattice(p); }))
        return true;
    std::vector<Vec3> places;
    for (const Vec3f& p : surface.points)
        places.push_back(p.cast<double>());
    const LatticeFit fit = fitToLattice(lattice, places, surface.triangles, control);
    if (fit.unsnappable > 0) {
        change.refusal = ModelRefusal::FacesMeet;
        change.faces = fit.unsnappable;
        return false;
    }
    for (Slot v = 0; v < surface.points.size(); ++v)
        surface.points[v] = lattice.toPoint(fit.points[v]);
    return !control.isCancelled();
}
} // namespace core
