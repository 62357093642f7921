#pragma once

#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// A dab's own axes, of unit length: to the right and up as its alpha or brush model has them, and out of the surface.
/// Right-handed, but left-handed for a mirrored dab. All zero where the surface has no mean normal.
struct DabFrame
{
    Vec3 right = Vec3::Zero(), up = Vec3::Zero(), normal = Vec3::Zero();
};

/// Returns the axes on the region's mean plane, or across the dab's normal if it has one. Up is the world's, and where
/// the plane is nearly level, away from who stands before it; with StrokeSettings::alphaFollows the stroke's way, once
/// there is one.
DabFrame frameOn(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab);
/// In empty space: the normal is up.
DabFrame uprightFrame(const Dab& dab);
} // namespace core
