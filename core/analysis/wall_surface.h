#pragma once

#include "core/analysis/wall_edges.h"
#include "core/analysis/wall_tree.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_distance.h"
#include "core/geometry/triangle_mesh.h"

#include <optional>
#include <span>

namespace core
{
/// A diameter where no opposite face is found.
constexpr double noBall = std::numeric_limits<double>::infinity();

/// A triangle within a face, by the weights that its corners give to the face's. Halving gives weights that doubles
/// hold exactly, so that a weight of 0 tells that a corner lies on a side of the face.
struct WallCell
{
    std::array<Vec3, 3> weights = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

    Vec3 centre() const { return (weights[0] + weights[1] + weights[2]) / 3; }
};

/// The thinnest place of a cell.
struct ThinnestPlace
{
    double diameter = noBall;  ///< of its ball; noBall: none below what was asked for
    Vec3 point = Vec3::Zero(); ///< of the surface; not on the cell's border
    /// The least ball of opposite points that are not in sight of the cell's nearest point; points near them may be.
    double hidden = noBall;
};

/// The surface of a solid, seen from within: answers how thick the matter is at one of its points, or at the thinnest
/// one of a part of a face. Points are of a face at a position of the tree, so that neighbours ask about the same
/// boxes.
class WallSurface
{
public:
    /// Keeps a reference to the mesh.
    explicit WallSurface(const TriangleMesh& mesh);

    std::size_t size() const { return m_walls.size(); }
    /// Returns whether there are so many faces that each may be measured less well: its neighbours make up for it.
    bool hasMany() const { return size() > 100'000; }
    Slot faceAt(Slot position) const { return m_walls[position].face; }
    bool hasArea(Slot position) const { return !m_walls[position].normal.isZero(); }
    double radiusOf(Slot position) const; ///< from the centre to the farthest corner
    double areaOf(Slot position) const;
    std::array<Vec3, 3> cornersOf(Slot position) const;
    Vec3 pointOf(Slot position, const Vec3& weights) const;

    /// The least ball that one of five rays finds, one along the normal and, unless that says that it is thicker than
    /// `largest`, four around it. Infinity if no opposite face is hit.
    double byRays(Slot position, const Vec3& p, double largest) const;
    /// The ball that no opposite face in sight of p reaches into, from one with the diameter `start` on; infinity if
    /// there is none below.
    double byBall(Slot position, const Vec3& p, double start) const;
    /// Returns the length of the matter along the normal; 0 if that cannot be told.
    double depthBehind(Slot position, const Vec3& p) const;
    /// Measures all points of the cell at once: lifted by the radius, it is the locus of the balls' centres. Opposite
    /// faces that the cell touches, at an edge or corner of the solid, do not count.
    ThinnestPlace thinnestIn(Slot position, const WallCell& cell, double start) const;
    /// Returns whether no face lies between two points of the surface that see each other through the matter.
    bool areInSight(const Vec3& p, const Vec3& q) const;
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
    struct Hit
    {
        Slot position = noSlot;
        double distance = std::numeric_limits<double>::infinity(); ///< in the direction's length
    };
    struct Touch
    {
        Vec3 p, q;
        Slot position;
    };
    class LiftedCell;

    WallSurface(const TriangleMesh& mesh, const BoxTree& tree);
    static Wall wallOf(const TriangleMesh& mesh, Slot face);
    Vec3 inwardOf(Slot position) const { return -m_walls[position].normal.cast<double>(); }
    bool areOpposite(Slot a, Slot b) const;
    double reach(Slot position, const Vec3& p) const;
    bool mayTouch(Slot position, Slot other) const;
    bool doTouch(Slot position, const WallCell& cell, Slot other) const;
    Hit firstHit(Slot from, const Vec3& origin, const Vec3& direction, double farthest) const;
    double ballOfRay(Slot position, const Vec3& origin, const Vec3& direction, double largest) const;
    double secondStart(double diameter) const;
    double shrunk(Slot position, const Vec3& p, double start) const;
    double shrunkInSight(Slot position, const Vec3& p, double start) const;
    ThinnestPlace shrunk(Slot position, const WallCell& cell, double start) const;
    bool isInSight(Slot position, const Vec3& p, const Vec3& q) const;
    template <typename NearestOfFace, typename NearestOfSide>
    NearestPair nearestOf(Slot position, const Vec3& inward, Slot other, NearestOfFace ofFace,
                          NearestOfSide ofSide) const;
    std::optional<Touch> nearestOpposite(Slot position, const Vec3& p, double radius,
                                         std::span<const Slot> hidden) const;
    std::optional<Touch> nearestOpposite(Slot position, const WallCell& cell, const LiftedCell& lifted, double radius,
                                         std::span<const Slot> hidden) const;

    const TriangleMesh& m_mesh;
    WallEdges m_edges;
    WallTree m_tree;
    std::vector<Wall> m_walls; ///< by position
    double m_shallow;
};
} // namespace core
