#pragma once

#include "vr/simulator/session.h"
#include "vr/simulator/simulated_world.h"

#include <variant>

namespace simulator
{
class Action;

/// Pose and motion of an object, relative to the room or to a space.
struct SpaceLocation
{
    vr::Pose pose;
    Tracking tracking = Tracking::Full;
    core::Vec3 velocity = core::Vec3::Zero(); ///< metres a second
    core::Vec3 turning = core::Vec3::Zero();  ///< radians a second

    bool isValid() const { return tracking != Tracking::None; }
    bool hasPosition() const { return tracking < Tracking::NoPosition; }
    /// Returns the location of a point that is fixed to this object.
    SpaceLocation with(const vr::Pose& own) const;
    /// Returns the location relative to `base`, which may move too.
    SpaceLocation seenFrom(const SpaceLocation& base) const;
    /// Returns the bits of XrSpaceLocationFlags, which are also those of XrViewStateFlags.
    XrFlags64 flags() const;
};

class Space : public Object
{
public:
    /// A pose action and the hand whose pose is used; null path: any hand that has the action.
    struct OfAction
    {
        std::shared_ptr<Action> action;
        XrPath subaction = XR_NULL_PATH;
    };
    using Origin = std::variant<XrReferenceSpaceType, OfAction>;

    Space(Origin origin, const vr::Pose& offset) : m_origin(std::move(origin)), m_offset(offset) {}

    /// Returns the location in the room.
    SpaceLocation at(const SimulatedWorld& world, XrTime time) const;
    const Origin& origin() const { return m_origin; }

private:
    Origin m_origin;
    vr::Pose m_offset;
};

std::string nameOf(const Space& space);

struct ViewQuery
{
    const Space& space;
    XrViewConfigurationType views;
    std::uint32_t eye; ///< 0: the left or the only eye
    XrTime time;
};

/// Returns the location of an eye in the space of the query.
SpaceLocation locateView(const SimulatedWorld& world, const ViewQuery& query);
XrFovf fovOf(const Headset& headset, XrViewConfigurationType views, std::uint32_t eye);

/// Returns the valid parts of the pose. Invalid parts are all 0: a rotation of 0 cannot be mistaken for a rotation.
XrPosef poseOrNone(const SpaceLocation& located);
} // namespace simulator
