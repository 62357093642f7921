#pragma once

#include "core/geometry/geometry.h"
#include "core/mesh/draw_arrays.h"

#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <optional>

namespace ui
{
/// A mesh that the user of the headset holds in one hand.
struct GhostMesh
{
    /// shape in metres, in a space of its own; uploaded to the GPU again only if the pointer differs
    std::shared_ptr<const core::DrawArrays> shape;
    /// rotation and position (mm) in the document, applied after scaling the shape by HeadsetAvatar::metre
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// The user of the headset as shown in the window. Units: mm, in the document's space.
struct HeadsetAvatar
{
    std::optional<Eigen::Isometry3d> head; ///< pose with the origin between the eyes, -Z ahead, +Y up
    std::array<std::optional<GhostMesh>, 2> hands;
    std::optional<core::Sphere> brush;
    double radius = 0;   ///< radius of the brush, mm, for any shape of brush
    double metre = 1000; ///< mm of the document per metre of the user's room
};
} // namespace ui
