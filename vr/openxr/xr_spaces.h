#pragma once

#include "vr/openxr/xr_handle.h"
#include "vr/util/pose.h"

#include <optional>
#include <vector>

namespace vr
{
class Instance;

/// The spaces that a session measures in. Room space is STAGE, which has the real floor, or else LOCAL_FLOOR, which has
/// it, too; where the runtime has neither it is LOCAL, with the floor taken to be 1.5 m below the eyes. Members throw
/// XrError.
class Spaces
{
public:
    Spaces(const Instance& instance, XrSession session);

    XrSpace room() const { return m_room.get(); }
    /// In room space; none as long as the runtime has not known it. While it knows no more than how the head stands,
    /// that is where it was.
    std::optional<Pose> head(XrTime time);

    /// A person who recentres in the runtime's own menu is to stand where that says: from the event's time on our own
    /// recentring is void.
    void notePendingChange(const XrEventDataReferenceSpaceChangePending& event);
    /// To be called with each frame's time; whether room space is another from this frame on.
    bool advance(XrTime time);

    /// The room is put where this head is (room space), by its position and yaw only; the real floor stays. From the
    /// next advance() on.
    void recentre(const Pose& head);

private:
    XrSession m_session;
    XrReferenceSpaceType m_type = XR_REFERENCE_SPACE_TYPE_LOCAL;
    Pose m_base; ///< of the room in the runtime's space
    SpaceHandle m_room;
    SpaceHandle m_view;
    std::optional<Pose> m_head; ///< the last that was known
    std::optional<Pose> m_nextBase;
    std::vector<XrTime> m_changes; ///< that are to come
};
} // namespace vr
