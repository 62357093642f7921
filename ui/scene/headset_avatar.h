#pragma once

#include "core/geometry/geometry.h"
#include "core/mesh/draw_arrays.h"

#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <optional>

namespace ui
{
/// Something that a person in the headset holds.
struct Ghost
{
    std::shared_ptr<const core::DrawArrays> shape; ///< metres, in a space of its own; the same object is uploaded once
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< from there to the document's axes and origin
};

/// A person in the headset, as those at the window see them. In the document's space, mm.
struct Wearer
{
    std::optional<Eigen::Isometry3d> head; ///< the origin between the eyes, -Z ahead, +Y up
    std::array<std::optional<Ghost>, 2> hands;
    std::optional<core::Sphere> brush;
    double radius = 0;   ///< of the brush, whatever its shape
    double metre = 1000; ///< so many mm of the document are a metre of the person's room
};
} // namespace ui
