#include "vr/simulator/actions.h"
#include "vr/simulator/calls.h"
#include "vr/simulator/spaces.h"
#include "vr/simulator/system.h"
#include "vr/simulator/xr_pose.h"

namespace simulator
{
namespace
{
std::vector<XrReferenceSpaceType> offeredSpaces(const Session& session, const SimulatedWorld& world)
{
    std::vector<XrReferenceSpaceType> spaces{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
    if (world.hasStage)
        spaces.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
    if (session.instance().extensions.contains(localFloorExtension))
        spaces.push_back(localFloor);
    return spaces;
}

void requireSpace(const Session& session, const SimulatedWorld& world, XrReferenceSpaceType type)
{
    const auto offered = offeredSpaces(session, world);
    require(std::find(offered.begin(), offered.end(), type) != offered.end(), XR_ERROR_REFERENCE_SPACE_UNSUPPORTED,
            "the reference space is not offered");
}

void requireTime(XrTime time)
{
    require(time > 0, XR_ERROR_TIME_INVALID, "the time is not positive");
}

/// Writes the velocity into an XrSpaceVelocity of the chain, if there is one.
void tellVelocity(void* chain, const SpaceLocation& located)
{
    for (auto* it = static_cast<XrBaseOutStructure*>(chain); it; it = it->next) {
        if (it->type != XR_TYPE_SPACE_VELOCITY)
            continue;
        auto& velocity = reinterpret_cast<XrSpaceVelocity&>(*it);
        velocity.velocityFlags = 0;
        if (located.tracking == Tracking::Full)
            velocity.velocityFlags |= XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
        if (located.isValid())
            velocity.velocityFlags |= XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
        velocity.linearVelocity = toXr(located.velocity);
        velocity.angularVelocity = toXr(located.turning);
    }
}
} // namespace

XrResult enumerateReferenceSpaces(Call& call, XrSession handle, std::uint32_t capacity, std::uint32_t* count,
                                  XrReferenceSpaceType* spaces)
{
    const Session& session = call.get<Session>(handle);
    writeItems(OutputArray<XrReferenceSpaceType>{capacity, count, spaces}, offeredSpaces(session, call.runtime.world));
    return XR_SUCCESS;
}

XrResult createReferenceSpace(Call& call, XrSession handle, const XrReferenceSpaceCreateInfo* info, XrSpace* out)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    validated(out);
    requireSpace(session, call.runtime.world, info->referenceSpaceType);
    const auto space = std::make_shared<Space>(info->referenceSpaceType, fromXr(info->poseInReferenceSpace));
    *out = call.runtime.handles.add<XrSpace>(space, &session);
    call.line["space"] = nameOf(*space);
    return XR_SUCCESS;
}

XrResult getReferenceSpaceBoundsRect(Call& call, XrSession handle, XrReferenceSpaceType type, XrExtent2Df* bounds)
{
    const Session& session = call.get<Session>(handle);
    validated(bounds) = {};
    const SimulatedWorld& world = call.runtime.world;
    requireSpace(session, world, type);
    if (type != XR_REFERENCE_SPACE_TYPE_STAGE || !world.bounds)
        return XR_SPACE_BOUNDS_UNAVAILABLE;
    *bounds = *world.bounds;
    return XR_SUCCESS;
}

XrResult createActionSpace(Call& call, XrSession handle, const XrActionSpaceCreateInfo* info, XrSpace* out)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_ACTION_SPACE_CREATE_INFO);
    validated(out);
    call.get<Action>(info->action);
    const auto action = call.runtime.handles.get<Action>(info->action);
    require(action->type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH, "not a pose action");
    requireSubaction(session.instance().paths, *action, info->subactionPath);
    const auto space =
        std::make_shared<Space>(Space::OfAction{action, info->subactionPath}, fromXr(info->poseInActionSpace));
    *out = call.runtime.handles.add<XrSpace>(space, &session);
    return XR_SUCCESS;
}

XrResult locateSpace(Call& call, XrSpace handle, XrSpace baseHandle, XrTime time, XrSpaceLocation* location)
{
    const auto& space = call.get<Space>(handle);
    const auto& base = call.get<Space>(baseHandle);
    validated(location, XR_TYPE_SPACE_LOCATION);
    requireTime(time);
    const SimulatedWorld& world = call.runtime.world;
    const SpaceLocation located = space.at(world, time).seenFrom(base.at(world, time));
    location->locationFlags = located.flags();
    location->pose = poseOrNone(located);
    tellVelocity(location->next, located);
    return XR_SUCCESS;
}

XrResult destroySpace(Call& call, XrSpace handle)
{
    call.runtime.handles.destroy(*call.runtime.handles.find<Space>(handle));
    return XR_SUCCESS;
}

XrResult locateViews(Call& call, XrSession handle, const XrViewLocateInfo* info, XrViewState* state,
                     std::uint32_t capacity, std::uint32_t* count, XrView* views)
{
    call.get<Session>(handle);
    validated(info, XR_TYPE_VIEW_LOCATE_INFO);
    validated(state, XR_TYPE_VIEW_STATE);
    const auto& space = call.get<Space>(info->space);
    const SimulatedWorld& world = call.runtime.world;
    requireViews(world, info->viewConfigurationType);
    requireTime(info->displayTime);
    std::vector<std::uint32_t> eyes(viewCount(info->viewConfigurationType));
    std::iota(eyes.begin(), eyes.end(), 0U);
    writeItems(OutputArray<XrView>{capacity, count, views}, eyes, [&](XrView& to, std::uint32_t eye) {
        const SpaceLocation located = locateView(world, {space, info->viewConfigurationType, eye, info->displayTime});
        validated(&to, XR_TYPE_VIEW).pose = poseOrNone(located);
        to.fov = fovOf(world.headset, info->viewConfigurationType, eye);
        state->viewStateFlags = located.flags();
    });
    return XR_SUCCESS;
}
} // namespace simulator
