#include "vr/openxr/xr_hand_trackers.h"

#include "vr/openxr/xr_convert.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
static_assert(jointCount == XR_HAND_JOINT_COUNT_EXT);

constexpr double minJointRadius = 0.002, maxJointRadius = 0.04; ///< of a joint that is drawn, metres
} // namespace

HandTrackers::HandTrackers(const Instance& instance, XrSession session)
{
    if (!instance.has(XR_EXT_HAND_TRACKING_EXTENSION_NAME))
        return;
    try {
        const auto create = instance.function<PFN_xrCreateHandTrackerEXT>("xrCreateHandTrackerEXT");
        m_destroy = instance.function<PFN_xrDestroyHandTrackerEXT>("xrDestroyHandTrackerEXT");
        m_locate = instance.function<PFN_xrLocateHandJointsEXT>("xrLocateHandJointsEXT");
        for (const Side side : {Side::Left, Side::Right}) {
            const XrHandTrackerCreateInfoEXT info{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr,
                                                  side == Side::Left ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT,
                                                  XR_HAND_JOINT_SET_DEFAULT_EXT};
            check(create(session, &info, &m_trackers[static_cast<std::size_t>(side)]), "xrCreateHandTrackerEXT");
        }
    } catch (const XrError& error) {
        qInfo("The OpenXR runtime tells no joints of hands: %s", qPrintable(error.text()));
    }
}

HandTrackers::~HandTrackers()
{
    for (XrHandTrackerEXT tracker : m_trackers)
        if (tracker != XR_NULL_HANDLE)
            m_destroy(tracker);
}

std::optional<HandJoints> HandTrackers::locate(Side side, XrSpace room, XrTime time) const
{
    XrHandTrackerEXT tracker = m_trackers[static_cast<std::size_t>(side)];
    if (tracker == XR_NULL_HANDLE)
        return {};
    std::array<XrHandJointLocationEXT, jointCount> located{};
    const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, room, time};
    XrHandJointLocationsEXT locations{};
    locations.type = XR_TYPE_HAND_JOINT_LOCATIONS_EXT;
    locations.jointCount = static_cast<std::uint32_t>(located.size());
    locations.jointLocations = located.data();
    if (XR_FAILED(m_locate(tracker, &info, &locations)) || !locations.isActive)
        return {};
    HandJoints joints;
    for (std::size_t i = 0; i < jointCount; ++i) {
        const XrHandJointLocationEXT& joint = located[i];
        const bool isKnown = (joint.locationFlags & XR_SPACE_LOCATION_POSITION_VALID_BIT) != 0;
        if (!isKnown || !isFinitePosition(joint.pose.position))
            return {};
        joints[i].position = core::Vec3(joint.pose.position.x, joint.pose.position.y, joint.pose.position.z);
        if (std::isfinite(joint.radius))
            joints[i].radius = std::clamp(static_cast<double>(joint.radius), minJointRadius, maxJointRadius);
    }
    return joints;
}
} // namespace vr
