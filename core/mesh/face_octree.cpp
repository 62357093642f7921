#include "core/mesh/face_octree.h"

#include "core/util/parallel.h"

#include <algorithm>
#include <bit>

namespace core
{
namespace
{
/// Smallest side of a cell, as a multiple of the longest extent of a face that is put in it.
constexpr int cellPerFace = 2;
constexpr int smallestUsefulCell = 64; ///< in lattice units; smaller cells do not make queries faster
/// Largest factor by which a cell may exceed the best size for a face before the face is moved to another cell.
constexpr int tolerance = 4;
/// Number of cells that a core processes at a time.
constexpr std::size_t cellsPerChunk = 64;

int cellSizeFor(const LatticeBox& box)
{
    const int extent = (box.max - box.min).maxCoeff();
    const unsigned size = std::bit_ceil(static_cast<unsigned>(cellPerFace * extent));
    return std::clamp(static_cast<int>(size), smallestUsefulCell, 2 * Lattice::limit);
}
} // namespace

LatticeBox boxOf(const Mesh& mesh, Slot face)
{
    const Triangle& t = mesh.corners(face);
    const LatticePoint a = mesh.latticePoint(t[0]), b = mesh.latticePoint(t[1]), c = mesh.latticePoint(t[2]);
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

FaceOctree::FaceOctree(const Mesh& mesh)
{
    m_root = rootOf(m_active);
    const Slot faces = mesh.slots().faces;
    m_places.reserve(static_cast<std::size_t>(faces) * 4); // costs address space only; avoids reallocation in a stroke
    m_places.resize(faces);
    for (const Slot f : mesh.faces())
        insert(f, mesh.partOfFace(f), boxOf(mesh, f));
    m_nodes.reserve(4 * m_nodes.size());
    m_cells.reserve(4 * m_cells.size());
}

void FaceOctree::activate(PartId part)
{
    m_active = part;
    m_root = rootOf(part);
}

void FaceOctree::update(const Mesh& mesh, std::span<const Slot> faces)
{
    removeDead(mesh, faces);
    for (Slot f : faces) {
        if (f < mesh.slots().faces && mesh.isFace(f))
            place(f, mesh.partOfFace(f), boxOf(mesh, f));
    }
}

void FaceOctree::removeDead(const Mesh& mesh, std::span<const Slot> faces)
{
    for (Slot f : faces) {
        const bool live = f < mesh.slots().faces && mesh.isFace(f);
        if (!live && f < m_places.size() && m_places[f].node != noSlot)
            remove(f);
    }
}

void FaceOctree::place(const Mesh& mesh, std::span<const Slot> faces, std::span<const LatticeBox> boxes)
{
    for (std::size_t i = 0; i < faces.size(); ++i)
        place(faces[i], mesh.partOfFace(faces[i]), boxes[i]);
}

void FaceOctree::place(Slot face, PartId part, const LatticeBox& box)
{
    if (face >= m_places.size())
        m_places.resize(face + 1);
    if (m_places[face].node != noSlot) {
        if (fits(face, part, box))
            return;
        remove(face);
    }
    insert(face, part, box);
}

bool FaceOctree::fits(Slot face, PartId part, const LatticeBox& box) const
{
    const Cell& cell = m_cells[m_places[face].node];
    return m_nodes[cell.node].part == part && cell.loose().contains(box) && cell.size <= tolerance * cellSizeFor(box);
}

void FaceOctree::insert(Slot face, PartId part, const LatticeBox& box)
{
    const Cell cell = cellFor(part, box);
    Node& node = m_nodes[cell.node];
    m_places[face] = {cell.node, static_cast<Slot>(node.faces.size())};
    node.faces.push_back(face);
    for (Slot n = cell.node; n != noSlot; n = m_nodes[n].parent)
        ++m_nodes[n].facesBelow;
    m_smallestCell = std::min(m_smallestCell, cell.size);
}

void FaceOctree::remove(Slot face)
{
    const Place place = m_places[face];
    std::vector<Slot>& faces = m_nodes[place.node].faces;
    faces[place.index] = faces.back();
    m_places[faces.back()].index = place.index;
    faces.pop_back();
    m_places[face] = {};
    for (Slot n = place.node; n != noSlot; n = m_nodes[n].parent)
        --m_nodes[n].facesBelow;
}

Slot FaceOctree::rootOf(PartId part)
{
    if (part >= m_roots.size())
        m_roots.resize(part + std::size_t(1), noSlot);
    if (m_roots[part] == noSlot) {
        m_roots[part] = static_cast<Slot>(m_nodes.size());
        m_nodes.emplace_back().part = part;
        m_cells.push_back(rootCell(m_roots[part]));
    }
    return m_roots[part];
}

FaceOctree::Cell FaceOctree::cellFor(PartId part, const LatticeBox& box)
{
    const int size = cellSizeFor(box);
    const LatticePoint center = ((box.min.cast<std::int64_t>() + box.max.cast<std::int64_t>()) / 2).cast<int>();
    Cell cell = rootCell(rootOf(part));
    while (cell.size > size) {
        if (m_nodes[cell.node].firstChild == noSlot) {
            const Slot first = static_cast<Slot>(m_nodes.size());
            m_nodes[cell.node].firstChild = first;
            for (int i = 0; i < 8; ++i) {
                Node& child = m_nodes.emplace_back();
                child.parent = cell.node;
                child.part = part;
                m_cells.push_back(cell.child(m_nodes[cell.node], i));
            }
        }
        const LatticePoint offset = center - cell.min;
        const int half = cell.size / 2;
        const int i = (offset.x() >= half ? 1 : 0) + (offset.y() >= half ? 2 : 0) + (offset.z() >= half ? 4 : 0);
        cell = cell.child(m_nodes[cell.node], i);
    }
    return cell;
}

bool FaceOctree::isConsistent(const Mesh& mesh) const
{
    Slot placed = 0;
    for (Slot n = 0; n < m_nodes.size(); ++n) {
        const Node& node = m_nodes[n];
        Slot below = static_cast<Slot>(node.faces.size());
        for (Slot child = node.firstChild; node.firstChild != noSlot && child < node.firstChild + 8; ++child)
            below += m_nodes[child].facesBelow;
        if (below != node.facesBelow)
            return false;
        for (Slot i = 0; i < node.faces.size(); ++i) {
            const Slot f = node.faces[i];
            const bool right = f < mesh.slots().faces && mesh.isFace(f) && mesh.partOfFace(f) == node.part &&
                               m_places[f].node == n && m_places[f].index == i &&
                               m_cells[n].loose().contains(boxOf(mesh, f));
            if (!right)
                return false;
            ++placed;
        }
    }
    return placed == mesh.live().faces;
}

std::vector<Slot> facesIn(const Mesh& mesh, const FaceOctree& octree, const LatticeBox& box)
{
    struct CellFaces
    {
        std::span<const Slot> faces;
        bool inside; ///< the box contains the cell's loose box, and so all its faces
    };
    std::vector<CellFaces> cells;
    octree.queryCells(box, [&](std::span<const Slot> faces, const LatticeBox& loose) {
        cells.push_back({faces, box.contains(loose)});
    });

    const Vec3f low = mesh.lattice().toPoint(box.min), high = mesh.lattice().toPoint(box.max);
    const auto meets = [&](Slot f) {
        const Triangle& t = mesh.corners(f);
        const Vec3f a = mesh.point(t[0]), b = mesh.point(t[1]), c = mesh.point(t[2]);
        for (int k = 0; k < 3; ++k) {
            if (std::max({a[k], b[k], c[k]}) < low[k] || std::min({a[k], b[k], c[k]}) > high[k])
                return false;
        }
        return true;
    };
    return joinChunks<std::vector<Slot>>(cells.size(), cellsPerChunk,
                                         [&](std::size_t begin, std::size_t end, std::vector<Slot>& found) {
                                             for (std::size_t i = begin; i < end; ++i) {
                                                 for (Slot f : cells[i].faces) {
                                                     if (mesh.isFace(f) && (cells[i].inside || meets(f)))
                                                         found.push_back(f);
                                                 }
                                             }
                                         });
}
} // namespace core
