#pragma once

#include "core/sculpt/deform/motion_limits.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/stroke/stroke.h"

namespace core
{
/// The state of a grab, except its vertices. A grab is the selection that Grab or Twist keeps for a whole stroke.
struct GrabState
{
    bool isOn = false;
    /// mirrored stroke: the region holds only the grabbed vertices on the mirror's positive side and represents both
    /// sides
    bool isHalf = false;
    Vec3 axis = Vec3::Zero();  ///< mean normal of the region at the time of grabbing, of unit length, or zero
    Vec3 moved = Vec3::Zero(); ///< Grab: motion of the stroke so far, mm
    double detail = 0;         ///< d_detail, mm, with which remeshing keeps the mesh as fine as it was when grabbed
    /// number of entries of Mesh::removedVertices() that have been dropped from the region already
    std::size_t known = 0;
    /// motion of the last dab; if the next dab moves in nearly this direction, `limits` are still valid
    Vec3 way = Vec3::Zero();
    MotionLimits limits{};      ///< motion limits at the end of the last dab
    unsigned fallbackSteps = 0; ///< fallback steps done since these limits were set
};

/// The region under the brush. A tool that keeps its selection (Grab, Twist) grabs the region with the first dab of a
/// stroke and deforms these vertices from then on, wherever they move.
struct Grab
{
    /// Stores the mean normal and the mean edge length of the region just selected; keep() needs them.
    void measure(const Mesh& mesh);
    /// Marks the region as grabbed, for the following dabs of the stroke. `motion`: by which the dab has moved a vertex
    /// of weight 1, mm.
    void keep(const Mesh& mesh, bool isHalf, const Vec3& motion);
    void release() { state = {}; }

    /// Adds the vertices at the far ends of long edges that leave the region, with weight zero. Otherwise such an edge
    /// would never be split and would soon limit the motion. With Grab, also adds the vertices that it pushes
    /// (GrabPush).
    void grow(const StrokeSettings& settings, const Mesh& mesh, const Dab& dab);
    /// Removes the vertices that other dabs have deleted from the mesh. Their slots may already be used by new
    /// vertices.
    void dropRemoved(const Mesh& mesh);

    /// Returns the faces that have a corner in the region, ascending by slot.
    std::vector<Slot> faces(const Mesh& mesh);
    /// Returns a ball that contains the region.
    Sphere ball(const Mesh& mesh) const;
    /// Returns the edge bounds that keep the grabbed surface as fine as it was at the time of grabbing. Returns
    /// `bounds` for tools that grab nothing, with Topology::Uniform, if no edge was grabbed, or if the grabbed surface
    /// was coarser.
    EdgeBounds bounds(const StrokeSettings& settings, const Mesh& mesh, const EdgeBounds& bounds) const;

    /// Returns whether the motion limits of the previous dab are still valid: the dab moves in nearly the same
    /// direction.
    bool isLimitedFor(const Dab& dab) const;
    void noteLimits(const Dab& dab, MotionLimits limits, unsigned fallbackSteps);

    Region region;
    GrabState state;

private:
    void growPushed(const StrokeSettings& settings, const Mesh& mesh, const Dab& dab, double detail);
};

/// The grabs of a stroke in one sector. A mirrored stroke on a model that is not symmetric needs one grab per side.
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
