#pragma once

#include "core/geometry/geometry.h"
#include "core/mesh/draw_arrays.h"

#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <optional>

namespace ui
{
/// The mesh of something that the user of the headset holds.
struct GhostMesh
{
    std::shared_ptr<const core::DrawArrays> shape; ///< metres, in a space of its own; the same object is uploaded once
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< from there to the document's axes and origin
};

/// The user of the headset as shown in the window. In the document's space, mm.
struct HeadsetAvatar
{
    std::optional<Eigen::Isometry3d> head; ///< the origin between the eyes, -Z ahead, +Y up
    std::array<std::optional<GhostMesh>, 2> hands;
    std::optional<core::Sphere> brush;
    double radius = 0;   ///< of the brush, whatever its shape
    double metre = 1000; ///< so many mm of the document are a metre of the person's room
};
} // namespace ui
