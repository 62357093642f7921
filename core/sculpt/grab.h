#pragma once

#include "core/sculpt/deform/motion_limits.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// The state of a grab, besides its vertices.
struct GrabState
{
    bool isOn = false;
    bool isHalf = false;        ///< the region is the half of what was grabbed, and stands for both sides of the mirror
    Vec3 axis = Vec3::Zero();   ///< mean normal when it was grabbed, of unit length or zero
    double detail = 0;          ///< d_detail that keeps it as fine as it was then, in mm
    std::size_t known = 0;      ///< removed vertices of the mesh that are no longer in the region, by their count
    Vec3 way = Vec3::Zero();    ///< motion of the last dab: if the next one goes the same way, `limits` still hold
    MotionLimits limits{};      ///< left by the last dab
    unsigned fallbackSteps = 0; ///< done within these limits
};

/// The region under the brush. A tool that keeps its selection grabs it with the first dab of a stroke, and works on it
/// from then on, wherever that goes.
struct Grab
{
    /// Remembers the region that was just selected, for keep().
    void measure(const Mesh& mesh);
    /// Keeps the region for the dabs that follow.
    void keep(const Mesh& mesh, bool isHalf);
    void release() { state = {}; }

    /// Adds, with no weight, the vertices at the far ends of long edges that leave the region: such an edge would never
    /// be split, and would soon be in the way.
    void grow(const StrokeSettings& settings, const Mesh& mesh, double radius);
    /// Drops the vertices that other dabs have removed; their slots may be other vertices' by now.
    void dropRemoved(const Mesh& mesh);

    /// Returns the faces around the region, ascending.
    std::vector<Slot> faces(const Mesh& mesh);
    /// Returns a ball around the region.
    Sphere ball(const Mesh& mesh) const;
    /// Returns the edge lengths that keep what was grabbed as fine as it was; `bounds` if nothing was, or if it was
    /// coarser.
    EdgeBounds bounds(const StrokeSettings& settings, const Mesh& mesh, const EdgeBounds& bounds) const;

    /// Whether the limits of the dab before hold for this one.
    bool isLimitedFor(const Dab& dab) const;
    void noteLimits(const Dab& dab, MotionLimits limits, unsigned fallbackSteps);

    Region region;
    GrabState state;
};

/// The grabs of a stroke in one place. A mirrored stroke on a model that is not symmetric needs one for each side.
struct GrabPair
{
    void dropRemoved(const Mesh& mesh)
    {
        own.dropRemoved(mesh);
        image.dropRemoved(mesh);
    }

    Grab own;
    Grab image; ///< grab of the dab's mirror image
};
} // namespace core
