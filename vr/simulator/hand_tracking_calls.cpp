#include "vr/simulator/calls.h"
#include "vr/simulator/spaces.h"

namespace simulator
{
namespace
{
class HandTracker : public Object
{
public:
    explicit HandTracker(Hand of) : hand(of) {}

    const Hand hand;
};

constexpr float jointRadius = 0.009F; ///< metres
constexpr double fingerPitch = 0.02;  ///< distance from one finger to the next, metres

/// Returns the place of a joint of an open hand in the space of its grip, metres. `right`: 1 for the right hand, -1 for
/// the left one, whose thumb is at the other side.
core::Vec3 jointPlace(std::uint32_t joint, double right)
{
    switch (joint) {
    case XR_HAND_JOINT_PALM_EXT:
        return core::Vec3::Zero();
    case XR_HAND_JOINT_WRIST_EXT:
        return {0, 0, 0.07};
    default:
        break;
    }
    if (joint <= XR_HAND_JOINT_THUMB_TIP_EXT)
        return {-right * 0.04, 0, 0.04 - 0.025 * (joint - XR_HAND_JOINT_THUMB_METACARPAL_EXT)};
    const std::uint32_t inFingers = joint - XR_HAND_JOINT_INDEX_METACARPAL_EXT;
    const double finger = inFingers / 5, along = inFingers % 5;
    return {right * fingerPitch * (finger - 1.5), 0, 0.03 - 0.035 * along};
}
} // namespace

XrResult createHandTracker(Call& call, XrSession handle, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* out)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT);
    validated(out);
    const bool isHand = info->hand == XR_HAND_LEFT_EXT || info->hand == XR_HAND_RIGHT_EXT;
    require(isHand && info->handJointSet == XR_HAND_JOINT_SET_DEFAULT_EXT, XR_ERROR_VALIDATION_FAILURE,
            "no such hand or set of joints");
    const auto tracker = std::make_shared<HandTracker>(info->hand == XR_HAND_LEFT_EXT ? Hand::Left : Hand::Right);
    *out = call.runtime.handles.add<XrHandTrackerEXT>(tracker, &session);
    return XR_SUCCESS;
}

XrResult destroyHandTracker(Call& call, XrHandTrackerEXT handle)
{
    call.runtime.handles.destroy(*call.runtime.handles.find<HandTracker>(handle));
    return XR_SUCCESS;
}

XrResult locateHandJoints(Call& call, XrHandTrackerEXT handle, const XrHandJointsLocateInfoEXT* info,
                          XrHandJointLocationsEXT* locations)
{
    const auto& tracker = call.get<HandTracker>(handle);
    validated(info, XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT);
    validated(locations, XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
    require(locations->jointCount == XR_HAND_JOINT_COUNT_EXT, XR_ERROR_VALIDATION_FAILURE, "not as many joints");
    require(info->time > 0, XR_ERROR_TIME_INVALID, "the time is not positive");
    const SimulatedWorld& world = call.runtime.world;
    const SpaceLocation base = call.get<Space>(info->baseSpace).at(world, info->time);
    const Wand& wand = world.wands[static_cast<std::size_t>(tracker.hand)];
    const SpaceLocation grip{wand.grip.at(info->time), wand.isOn ? wand.tracking : Tracking::None};
    locations->isActive = grip.isValid() ? XR_TRUE : XR_FALSE;
    for (std::uint32_t joint = 0; joint < locations->jointCount; ++joint) {
        const double right = tracker.hand == Hand::Right ? 1 : -1;
        const SpaceLocation place =
            grip.with({Eigen::Quaterniond::Identity(), jointPlace(joint, right)}).seenFrom(base);
        (&validated(locations->jointLocations))[joint] = {place.flags(), poseOrNone(place), jointRadius};
    }
    return XR_SUCCESS;
}
} // namespace simulator
