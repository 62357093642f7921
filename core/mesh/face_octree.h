#pragma once

#include "core/geometry/lattice_box.h"
#include "core/mesh/mesh.h"

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

namespace core
{
LatticeBox boxOf(const Mesh& mesh, Slot face);

/// Loose octrees of faces (paper, section 3.1.1), one for each part of the mesh. Queries search the octree of the
/// active part, initially part 0. The root is the whole lattice and never changes. A face is stored in the cell that
/// contains its box's centre and whose side is two to four times the face's extent. The loose box of a cell has twice
/// the cell's side, so a face that moves or shrinks a little stays in its cell. Cells are never removed; queries skip a
/// subtree that has no faces.
class FaceOctree
{
public:
    explicit FaceOctree(const Mesh& mesh); ///< Cost: O(faces).

    /// Selects the part whose faces queries find. Cost: O(1).
    void activate(PartId part);
    PartId activePart() const { return m_active; }

    /// Updates faces that were created, moved or removed. Cost: O(faces given).
    void update(const Mesh& mesh, std::span<const Slot> faces);
    /// Two parts of update(): removeDead() takes out removed faces; place() puts live faces in the cells for their
    /// boxes.
    void removeDead(const Mesh& mesh, std::span<const Slot> faces);
    void place(const Mesh& mesh, std::span<const Slot> faces, std::span<const LatticeBox> boxes);

    /// Calls visit(face) for a superset of the faces that meet the box, in unspecified order. A face that moved since
    /// its last update() is found at its old place.
    template <class Visit> void query(const LatticeBox& box, Visit visit) const
    {
        queryCells(box, [&](std::span<const Slot> faces, const LatticeBox&) { std::ranges::for_each(faces, visit); });
    }

    /// Calls visit(faces, loose box) for each cell that query() would search.
    template <class Visit> void queryCells(const LatticeBox& box, Visit visit) const
    {
        queryNode(rootCell(m_root), box, visit);
    }

    /// Calls visit(face) for the faces of all cells that `enter(loose box)` accepts, together with all their parents.
    template <class Enter, class Visit> void traverse(Enter enter, Visit visit) const
    {
        traverseNode(rootCell(m_root), enter, visit);
    }

    /// Returns the side of the smallest cell ever used, lattice units; nearest-point searches start with it as radius.
    int smallestCell() const { return m_smallestCell; }
    /// Returns, for tests, whether every live face is in exactly one cell whose loose box contains it, and the counts
    /// are right. Queries then find what a rebuilt octree would find.
    bool isConsistent(const Mesh& mesh) const;

private:
    struct Node
    {
        Slot firstChild = noSlot; ///< first of eight children, in the order x + 2y + 4z
        Slot parent = noSlot;
        Slot facesBelow = 0; ///< faces of this node and of all nodes below
        PartId part = 0;
        std::vector<Slot> faces;
    };
    struct Cell
    {
        Slot node;
        LatticePoint min;
        int size;

        LatticeBox loose() const
        {
            return {min - LatticePoint::Constant(size / 2), min + LatticePoint::Constant(size + size / 2)};
        }
        Cell child(const Node& parent, int i) const
        {
            const int half = size / 2;
            return {parent.firstChild + static_cast<Slot>(i),
                    min + LatticePoint((i & 1) ? half : 0, (i & 2) ? half : 0, (i & 4) ? half : 0), half};
        }
        /// Returns a bit mask: bit i is set if the loose box of child i meets the box.
        unsigned childrenMeeting(const LatticeBox& box) const
        {
            constexpr std::array<unsigned, 3> lower = {0x55, 0x33, 0x0f}; // the children in an axis's lower half
            const int half = size / 2, loose = half / 2;
            unsigned children = 0xff;
            for (int k = 0; k < 3; ++k) {
                if (box.max[k] < min[k] - loose || box.min[k] > min[k] + half + loose)
                    children &= ~lower[k];
                if (box.max[k] < min[k] + half - loose || box.min[k] > min[k] + size + loose)
                    children &= lower[k];
            }
            return children;
        }
    };
    static Cell rootCell(Slot root) { return {root, LatticePoint::Constant(-Lattice::limit), 2 * Lattice::limit}; }

    /// Precondition: the cell's loose box meets the box.
    template <class Visit> void queryNode(const Cell& cell, const LatticeBox& box, Visit& visit) const
    {
        const Node& node = m_nodes[cell.node];
        if (!node.faces.empty())
            visit(std::span<const Slot>(node.faces), cell.loose());
        if (node.firstChild == noSlot)
            return;
        for (unsigned children = cell.childrenMeeting(box); children != 0; children &= children - 1) {
            const int i = std::countr_zero(children);
            if (m_nodes[node.firstChild + static_cast<Slot>(i)].facesBelow > 0)
                queryNode(cell.child(node, i), box, visit);
        }
    }
    template <class Enter, class Visit> void traverseNode(const Cell& cell, Enter& enter, Visit& visit) const
    {
        const Node& node = m_nodes[cell.node];
        if (node.facesBelow == 0 || !enter(cell.loose()))
            return;
        for (Slot f : node.faces)
            visit(f);
        if (node.firstChild == noSlot)
            return;
        for (int i = 0; i < 8; ++i)
            traverseNode(cell.child(node, i), enter, visit);
    }

    void place(Slot face, PartId part, const LatticeBox& box);
    bool fits(Slot face, PartId part, const LatticeBox& box) const;
    void insert(Slot face, PartId part, const LatticeBox& box);
    void remove(Slot face);
    Slot rootOf(PartId part);
    Cell cellFor(PartId part, const LatticeBox& box);

    struct Place
    {
        Slot node = noSlot;
        Slot index = 0;
    };
    std::vector<Node> m_nodes;
    std::vector<Place> m_places; ///< cell of each face
    std::vector<Cell> m_cells;   ///< bounds of each node
    std::vector<Slot> m_roots;   ///< root node by part; noSlot: the part has no octree yet
    PartId m_active = 0;
    Slot m_root = 0; ///< root of the active part
    int m_smallestCell = 2 * Lattice::limit;
};

/// Returns exactly the faces whose boxes meet the box, in unspecified order. Only faces that are in the octree and
/// alive in the mesh count. A face that moved since its last update() may be missed or be found at its old place.
std::vector<Slot> facesIn(const Mesh& mesh, const FaceOctree& octree, const LatticeBox& box);
} // namespace core
