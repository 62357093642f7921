#include "vr/simulator/spaces.h"

#include "vr/simulator/actions.h"
#include "vr/simulator/system.h"
#include "vr/simulator/xr_pose.h"

namespace simulator
{
namespace
{
static_assert(XR_SPACE_LOCATION_ORIENTATION_VALID_BIT == XR_VIEW_STATE_ORIENTATION_VALID_BIT &&
              XR_SPACE_LOCATION_POSITION_VALID_BIT == XR_VIEW_STATE_POSITION_VALID_BIT &&
              XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT == XR_VIEW_STATE_ORIENTATION_TRACKED_BIT &&
              XR_SPACE_LOCATION_POSITION_TRACKED_BIT == XR_VIEW_STATE_POSITION_TRACKED_BIT);

SpaceLocation moving(const Motion& motion, Tracking tracking, XrTime time)
{
    return {motion.at(time), tracking, motion.velocity(time), motion.turning(time)};
}

SpaceLocation originAt(const SimulatedWorld& world, XrReferenceSpaceType type, XrTime time)
{
    const vr::Pose local = world.local.at(time);
    if (type == localFloor) // on the floor below the origin of LOCAL
        return {{local.rotation, {local.position.x(), 0, local.position.z()}}};
    switch (type) {
    case XR_REFERENCE_SPACE_TYPE_VIEW:
        return moving(world.head.motion, world.head.tracking, time);
    case XR_REFERENCE_SPACE_TYPE_STAGE:
        return {world.stage.at(time)};
    default:
        return {local};
    }
}

SpaceLocation wandAt(const SimulatedWorld& world, const Source& source, XrTime time)
{
    const Wand& wand = world.wands[static_cast<std::size_t>(source.hand)];
    const SpaceLocation grip = moving(wand.grip, wand.isOn ? wand.tracking : Tracking::None, time);
    if (source.kind == Source::Kind::Pinch)
        return grip.with(world.pinch);
    return source.kind == Source::Kind::Aim ? grip.with(world.aim) : grip;
}

SpaceLocation nowhere()
{
    return {{}, Tracking::None};
}
} // namespace

SpaceLocation SpaceLocation::with(const vr::Pose& own) const
{
    SpaceLocation point = *this;
    point.pose = pose * own;
    point.velocity += turning.cross(pose.rotation * own.position);
    return point;
}

SpaceLocation SpaceLocation::seenFrom(const SpaceLocation& base) const
{
    const vr::Pose inverse = base.pose.inverse();
    const core::Vec3 arm = pose.position - base.pose.position;
    SpaceLocation seen;
    seen.pose = inverse * pose;
    seen.tracking = std::max(tracking, base.tracking);
    seen.velocity = inverse.rotation * (velocity - base.velocity - base.turning.cross(arm));
    seen.turning = inverse.rotation * (turning - base.turning);
    return seen;
}

XrFlags64 SpaceLocation::flags() const
{
    constexpr XrFlags64 rotation = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
    switch (tracking) {
    case Tracking::Full:
        return rotation | XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    case Tracking::RotationOnly:
        return rotation | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    case Tracking::NoPosition:
        return rotation;
    case Tracking::None:
        break;
    }
    return 0;
}

SpaceLocation Space::at(const SimulatedWorld& world, XrTime time) const
{
    if (const auto* type = std::get_if<XrReferenceSpaceType>(&m_origin))
        return originAt(world, *type, time).with(m_offset);
    const auto& [action, subaction] = std::get<OfAction>(m_origin);
    const auto& session = static_cast<const Session&>(*parent);
    const auto source = session.isFocused() ? session.input.poseSource(*action, subaction) : std::nullopt;
    return source ? wandAt(world, *source, time).with(m_offset) : nowhere();
}

std::string nameOf(const Space& space)
{
    const auto* type = std::get_if<XrReferenceSpaceType>(&space.origin());
    if (!type)
        return "action";
    if (*type == localFloor)
        return "local_floor";
    switch (*type) {
    case XR_REFERENCE_SPACE_TYPE_VIEW:
        return "view";
    case XR_REFERENCE_SPACE_TYPE_STAGE:
        return "stage";
    default:
        return "local";
    }
}

SpaceLocation locateView(const SimulatedWorld& world, const ViewQuery& query)
{
    SpaceLocation eye = moving(world.head.motion, world.head.tracking, query.time);
    if (query.views == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO) {
        const double side = query.eye == 0 ? -0.5 : 0.5;
        eye = eye.with({Eigen::Quaterniond::Identity(), core::Vec3(side * world.headset.eyeDistance, 0, 0)});
    }
    return eye.seenFrom(query.space.at(world, query.time));
}

XrFovf fovOf(const Headset& headset, XrViewConfigurationType views, std::uint32_t eye)
{
    XrFovf fov = headset.fov;
    if (views != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
        fov.angleRight = -fov.angleLeft;
    else if (eye == 1)
        std::tie(fov.angleLeft, fov.angleRight) = std::pair(-fov.angleRight, -fov.angleLeft);
    return fov;
}

XrPosef poseOrNone(const SpaceLocation& located)
{
    XrPosef pose = located.isValid() ? toXr(located.pose) : XrPosef{};
    if (!located.hasPosition())
        pose.position = {};
    return pose;
}
} // namespace simulator
