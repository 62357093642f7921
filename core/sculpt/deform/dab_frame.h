#pragma once

#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// A dab's own axes, of unit length: right and up as seen in its alpha or brush model, and the normal out of the
/// surface. Right-handed; left-handed for a mirrored dab. All zero if the surface has no mean normal.
struct DabFrame
{
    Vec3 right = Vec3::Zero(), up = Vec3::Zero(), normal = Vec3::Zero();
};

/// Returns the axes for a dab on a surface. The normal is the dab's normal, or else the region's mean normal. Up is the
/// dab's up vector, projected onto the plane; where the plane is nearly level, Dab::ahead is projected instead. With
/// StrokeSettings::alphaFollows, up is the direction of the stroke, once it has moved.
DabFrame frameOn(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab);
/// Returns the axes for a dab in empty space: the normal is the dab's up vector, and up is Dab::ahead.
DabFrame uprightFrame(const Dab& dab);
} // namespace core
