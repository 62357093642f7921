#pragma once

#include "vr/input/model_placement.h"
#include "vr/scene/scene_state.h"

#include "core/primitives/primitives.h"

#include <optional>
#include <vector>

namespace vr
{
/// A tube that a hand draws: its middle follows the tip of the wand. It stays in its place in the model when the model
/// is moved. Space: document, mm. Thread: the headset's.
class TubeDrawing
{
public:
    static constexpr double minLength = 0.01; ///< metres in the room; a shorter path makes no tube
    /// Number of points of the path while it is drawn. Before there are more, every second one goes, and those that
    /// follow are twice as far apart.
    static constexpr std::size_t maxPoints = 2000;

    bool isDrawing() const { return m_isDrawing; }
    void begin();
    /// Lets the path go on to a point. The last point is replaced if it is near to the one before it: by a tenth of the
    /// radius, and more after many points. Precondition: the radius is above 0.
    void add(const core::TubePoint& point);
    /// Ends the path. Returns the tube along it, with at most PrimitiveLimits::maxProfile points, which are at least
    /// its radius from each other (two may be nearer if there are no others); none if the path is too short, or the
    /// hand only shook in place. Cost: O(n log n) as a rule.
    std::optional<core::Primitive> end(const ModelPlacement& placement);

    /// Replaces `outline` by the path and rings around it, in room space: some hundred lines as a rule, at
    /// most 400 and maxPoints.
    void outlineTo(const ModelPlacement& placement, std::vector<Segment>& outline) const;

private:
    double length() const;

    bool m_isDrawing = false;
    double m_step = 0; ///< distance of points, at least, radii of the tube
    std::vector<core::TubePoint> m_path;
};
} // namespace vr
