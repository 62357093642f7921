#pragma once

#include "vr/openxr/hand_joints.h"
#include "vr/openxr/wand_state.h"
#include "vr/openxr/xr_instance.h"

namespace vr
{
/// Finds the joints of bare hands, so that they can be drawn, if the runtime reports them (XR_EXT_hand_tracking). A
/// runtime that refuses gets no drawn hands. No member throws.
class HandTrackers
{
public:
    HandTrackers(const Instance& instance, XrSession session);
    ~HandTrackers();
    HandTrackers(const HandTrackers&) = delete;
    HandTrackers& operator=(const HandTrackers&) = delete;

    /// Returns the joints at `time` in the space `room`; none if a joint's place is unknown.
    std::optional<HandJoints> locate(Side side, XrSpace room, XrTime time) const;

private:
    PFN_xrDestroyHandTrackerEXT m_destroy = nullptr;
    PFN_xrLocateHandJointsEXT m_locate = nullptr;
    std::array<XrHandTrackerEXT, sideCount> m_trackers{}; ///< indexed by Side; null: none
};
} // namespace vr
