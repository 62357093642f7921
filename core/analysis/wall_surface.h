#pragma once

#include "core/analysis/wall_edges.h"
#include "core/analysis/wall_tree.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"

namespace core
{
/// A diameter where no opposite face is found.
constexpr double noBall = std::numeric_limits<double>::infinity();

/// The surface of a solid, seen from within. Faces go by their positions in the tree, so that neighbours ask about the
/// same boxes.
class WallSurface
{
public:
    explicit WallSurface(const TriangleMesh& mesh);

    std::size_t size() const { return m_walls.size(); }
    /// Returns whether there are so many faces that each may be measured less well: its neighbours make up for it.
    bool hasMany() const { return size() > 100'000; }
    Slot faceAt(Slot position) const { return m_walls[position].face; }
    bool hasArea(Slot position) const { return !m_walls[position].normal.isZero(); }
    double areaOf(Slot position) const;
    std::array<Vec3, 3> cornersOf(Slot position) const;
    Vec3 pointOf(Slot position, const Vec3& weights) const;

    Vec3 inwardOf(Slot position) const { return -m_walls[position].normal.cast<double>(); }
    bool areOpposite(Slot a, Slot b) const;
    /// Returns whether a ball at a face may touch another one, or an edge or corner of it.
    bool mayTouch(Slot position, Slot other) const;
    /// Returns a bound from below of the squared distance from a point to a face.
    double reach(Slot position, const Vec3& p) const;

    const WallTree& tree() const { return m_tree; }
    const WallEdges& edges() const { return m_edges; }

private:
    /// A face at its place in the tree.
    struct Wall
    {
        std::array<Vec3f, 3> corners;
        Vec3f normal;      ///< unit length, or zero
        Vec3f across;      ///< in the face, across its longest side
        float least, most; ///< along that, from the first corner
        Slot face;
        bool isAtEdge = false; ///< see WallEdges
    };
    WallSurface(const TriangleMesh& mesh, const BoxTree& tree);
    static Wall wallOf(const TriangleMesh& mesh, Slot face);

    WallEdges m_edges;
    WallTree m_tree;
    std::vector<Wall> m_walls; ///< by position
};
} // namespace core
