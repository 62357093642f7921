#pragma once

#include "core/analysis/wall_rays.h"
#include "core/geometry/triangle_distance.h"

#include <optional>
#include <span>

namespace core
{
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

/// Measures thickness by balls, at points of a face or at the thinnest point of a part of it.
class WallBalls
{
public:
    /// Keeps references.
    WallBalls(const TriangleMesh& mesh, const WallSurface& surface, const WallRays& rays);

    /// The ball that no opposite face in sight of p reaches into, from one with the diameter `start` on; infinity if
    /// there is none below.
    double byBall(Slot position, const Vec3& p, double start) const;
    /// Measures all points of the cell at once: lifted by the radius, it is the locus of the balls' centres. Opposite
    /// faces that the cell touches, at an edge or corner of the solid, do not count.
    ThinnestPlace thinnestIn(Slot position, const WallCell& cell, double start) const;

private:
    struct Touch
    {
        Vec3 p, q;
        Slot position;
    };
    class LiftedCell;

    double secondStart(double diameter) const;
    double shrunk(Slot position, const Vec3& p, double start) const;
    double shrunkInSight(Slot position, const Vec3& p, double start) const;
    ThinnestPlace shrunk(Slot position, const WallCell& cell, double start) const;
    bool doTouch(Slot position, const WallCell& cell, Slot other) const;
    template <typename NearestOfFace, typename NearestOfSide>
    NearestPair nearestOf(Slot position, const Vec3& inward, Slot other, NearestOfFace ofFace,
                          NearestOfSide ofSide) const;
    std::optional<Touch> nearestOpposite(Slot position, const Vec3& p, double radius,
                                         std::span<const Slot> hidden) const;
    std::optional<Touch> nearestOpposite(Slot position, const WallCell& cell, const LiftedCell& lifted, double radius,
                                         std::span<const Slot> hidden) const;

    const TriangleMesh& m_mesh;
    const WallSurface& m_surface;
    const WallRays& m_rays;
    double m_shallow;
};
} // namespace core
