#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Turns, stretches and moves a part about a centre. A vertex that is masked, or hidden, keeps its place as far as it
/// is; in between, the turn is by a share of the angle: freedom w takes p to
///     centre + w by + R^w (I + w (A S A^T - I)) (p - centre)
/// with S = diag(scale), and R and A the matrices of `rotation` and `scaleAxes`. Space: document, mm.
struct Transform
{
    static constexpr double minScale = 1e-3;

    Vec3 centre = Vec3::Zero();
    Vec3 by = Vec3::Zero();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); ///< unit length
    Vec3 scale = Vec3::Ones();                                    ///< each from minScale to 1 / minScale
    /// Turn from the document's axes to those of `scale`, unit length
    Eigen::Quaterniond scaleAxes = Eigen::Quaterniond::Identity();

    /// Returns where a point with this freedom, 0 to 1, goes.
    Vec3 placeOf(const Vec3& p, double freedom) const;
    bool isNothing() const;
};
} // namespace core
