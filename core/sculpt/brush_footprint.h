#pragma once

#include "core/mesh/footprint.h"
#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// Finds what the next dab would select. Owns a region of its own: it may be asked in the middle of a dab.
class BrushFootprint
{
public:
    /// See Sculptor::footprint().
    Footprint find(const Mesh& mesh, const FaceOctree& octree, const StrokeSettings& settings, const Vec3& center);

private:
    Region m_region;
};
} // namespace core
