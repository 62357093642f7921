#pragma once

#include "vr/openxr/xr_handle.h"
#include "vr/util/pose.h"

#include <optional>
#include <vector>

namespace vr
{
class Instance;

/// The reference spaces of a session. Room space is STAGE or else LOCAL_FLOOR, whose floor is the real one. If the
/// runtime has neither, room space is LOCAL, with the floor assumed 1.5 m below the eyes. The constructor, head() and
/// advance() throw XrError.
class Spaces
{
public:
    Spaces(const Instance& instance, XrSession session);

    XrSpace room() const { return m_room.get(); }
    /// Returns the head in room space; none until the runtime has reported it. While only the orientation is known, the
    /// head keeps its last position.
    std::optional<Pose> head(XrTime time);

    /// Records that the runtime will redefine its space, for example because the user recentres in its menu. The new
    /// origin replaces any recentring by Fettle, from the event's time on.
    void notePendingChange(const XrEventDataReferenceSpaceChangePending& event);
    /// Applies pending changes of room space. To be called with each frame's time. Returns whether room space is
    /// redefined from this frame on.
    bool advance(XrTime time);

    /// Moves the room's origin to this head (in room space) by its position and yaw only; a real floor keeps its
    /// height. Takes effect at the next advance().
    void recentre(const Pose& head);

private:
    XrSession m_session;
    XrReferenceSpaceType m_type = XR_REFERENCE_SPACE_TYPE_LOCAL;
    Pose m_base; ///< pose of the room in the runtime's space
    SpaceHandle m_room;
    SpaceHandle m_view;
    std::optional<Pose> m_head; ///< last known pose of the head, room space
    std::optional<Pose> m_nextBase;
    std::vector<XrTime> m_changes; ///< times of pending changes of the runtime's space
};
} // namespace vr
