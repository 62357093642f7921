#pragma once

#include "core/geometry/triangle_distance.h"
#include "core/print/wall_rays.h"

#include <optional>
#include <span>

namespace core
{
/// A triangle within a face. Its corners are barycentric weights of the face's corners. Halving keeps the weights exact
/// in doubles, so a weight of exactly 0 means that a corner is on a side of the face.
struct WallCell
{
    std::array<Vec3, 3> weights = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

    Vec3 centre() const { return (weights[0] + weights[1] + weights[2]) / 3; }
};

/// The thinnest place of a cell.
struct ThinnestPlace
{
    double diameter = noBall;  ///< diameter of the ball there; noBall: none is smaller than the start value
    Vec3 point = Vec3::Zero(); ///< point on the surface, moved slightly inside the cell
    /// Diameter of the least ball whose opposite points are hidden from the cell's nearest point. Points near them may
    /// be visible.
    double hidden = noBall;
};

/// Measures wall thickness with balls inside the solid, at a point of a face or at the thinnest point of a part of it.
class WallBalls
{
public:
    /// Keeps references to all three arguments.
    WallBalls(const TriangleMesh& mesh, const WallSurface& surface, const WallRays& rays);

    /// Returns the diameter of the ball at p that no visible opposite face reaches into. The search starts from the
    /// diameter `start`; returns infinity if no smaller ball is found.
    double byBall(Slot position, const Vec3& p, double start) const;
    /// Measures all points of a cell at once. The cell, lifted by the radius, is the locus of the balls' centres.
    /// Opposite faces that the cell touches, at an edge or corner of the solid, are ignored.
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
