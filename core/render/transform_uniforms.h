#pragma once

#include "core/parts/part_transform.h"

namespace core
{
/// A Transform as the uniforms of clay.vert, which shows it without changing the mesh. The vertex weights are the
/// freedoms (VertexWeightBuffer).
struct TransformUniforms
{
    Vec3f centre = Vec3f::Zero(), by = Vec3f::Zero();  ///< "moveCentre", "moveBy", mm
    Vec3f axis = Vec3f::UnitX();                       ///< "turnAxis", unit length
    float angle = 0;                                   ///< "turnAngle", radians
    Eigen::Matrix3f stretch = Eigen::Matrix3f::Zero(); ///< "stretch": A S A^T - I
};

TransformUniforms uniformsOf(const Transform& transform);
} // namespace core
