#pragma once

#include "vr/simulator/session.h"
#include "vr/simulator/simulated_world.h"

#include <variant>

namespace simulator
{
class Action;

/// Where something is, in the room or in a space.
struct SpaceLocation
{
    vr::Pose pose;
    Tracking tracking = Tracking::Full;
    core::Vec3 velocity = core::Vec3::Zero(); ///< metres a second
    core::Vec3 turning = core::Vec3::Zero();  ///< radians a second

    bool isValid() const { return tracking != Tracking::None; }
    bool hasPosition() const { return tracking < Tracking::NoPosition; }
    /// A point that is fixed to it.
    SpaceLocation with(const vr::Pose& own) const;
    /// As seen from there, which may move itself.
    SpaceLocation seenFrom(const SpaceLocation& base) const;
    /// The bits of XrSpaceLocationFlags, which are those of XrViewStateFlags.
    XrFlags64 flags() const;
};

class Space : public Object
{
public:
    /// A pose action and the hand that is asked for; null path: whichever has it.
    struct OfAction
    {
        std::shared_ptr<Action> action;
        XrPath subaction = XR_NULL_PATH;
    };
    using Origin = std::variant<XrReferenceSpaceType, OfAction>;

    Space(Origin origin, const vr::Pose& offset) : m_origin(std::move(origin)), m_offset(offset) {}

    /// In the room.
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
    std::uint32_t eye; ///< 0: left, or the only one
    XrTime time;
};

/// In that space.
SpaceLocation locateView(const SimulatedWorld& world, const ViewQuery& query);
XrFovf fovOf(const Headset& headset, XrViewConfigurationType views, std::uint32_t eye);

/// The pose as far as it is valid; else one that nobody can mistake for one.
XrPosef poseOrNone(const SpaceLocation& located);
} // namespace simulator
