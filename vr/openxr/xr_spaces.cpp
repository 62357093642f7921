#include "vr/openxr/xr_spaces.h"

#include "vr/openxr/xr_convert.h"
#include "vr/openxr/xr_instance.h"
#include "vr/openxr/xr_result.h"

#include <algorithm>
#include <utility>

namespace vr
{
namespace
{
/// Assumed height of the eyes above the floor, in metres, for a user who stands or sits high.
constexpr double eyeHeight = 1.5;

SpaceHandle makeSpace(XrSession session, XrReferenceSpaceType type, const Pose& pose)
{
    const XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, type, toXr(pose)};
    XrSpace made = XR_NULL_HANDLE;
    check(xrCreateReferenceSpace(session, &info, &made), "xrCreateReferenceSpace");
    return SpaceHandle(made);
}

/// XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT, also of the core of OpenXR 1.1, which older headers do not define.
constexpr auto localFloor = static_cast<XrReferenceSpaceType>(1000426000);

XrReferenceSpaceType roomSpaceType(const Instance& instance, XrSession session)
{
    const auto offered =
        enumerate("xrEnumerateReferenceSpaces", XrReferenceSpaceType{}, [&](auto capacity, auto* count, auto* items) {
            return xrEnumerateReferenceSpaces(session, capacity, count, items);
        });
    const auto has = [&](XrReferenceSpaceType type) { return std::ranges::find(offered, type) != offered.end(); };
    if (has(XR_REFERENCE_SPACE_TYPE_STAGE))
        return XR_REFERENCE_SPACE_TYPE_STAGE;
    const bool knowsLocalFloor = instance.has(localFloorExtension) || instance.version() >= XR_MAKE_VERSION(1, 1, 0);
    return knowsLocalFloor && has(localFloor) ? localFloor : XR_REFERENCE_SPACE_TYPE_LOCAL;
}

/// Returns the pose of the room in the runtime's space before the user has recentred.
Pose firstBase(XrReferenceSpaceType type)
{
    Pose base;
    if (type == XR_REFERENCE_SPACE_TYPE_LOCAL)
        base.position.y() = -eyeHeight;
    return base;
}
} // namespace

Spaces::Spaces(const Instance& instance, XrSession session)
    : m_session(session)
    , m_type(roomSpaceType(instance, session))
    , m_base(firstBase(m_type))
    , m_room(makeSpace(session, m_type, m_base))
    , m_view(makeSpace(session, XR_REFERENCE_SPACE_TYPE_VIEW, {}))
{}

std::optional<Pose> Spaces::head(XrTime time)
{
    XrSpaceLocation location{};
    location.type = XR_TYPE_SPACE_LOCATION;
    check(xrLocateSpace(m_view.get(), room(), time, &location), "xrLocateSpace");
    const bool isTurnKnown = (location.locationFlags & XR_SPACE_LOCATION_ORIENTATION_VALID_BIT) != 0 &&
                             isRotation(location.pose.orientation);
    if (isValid(location))
        m_head = fromXr(location.pose);
    else if (m_head && isTurnKnown)
        m_head->rotation = fromXr(location.pose).rotation;
    return m_head;
}

void Spaces::notePendingChange(const XrEventDataReferenceSpaceChangePending& event)
{
    if (event.session == m_session && event.referenceSpaceType == m_type)
        m_changes.push_back(event.changeTime);
}

bool Spaces::advance(XrTime time)
{
    const bool isChanged = std::erase_if(m_changes, [&](XrTime change) { return change <= time; }) > 0;
    if (isChanged)
        m_nextBase = firstBase(m_type);
    if (!m_nextBase)
        return false;
    m_base = *std::exchange(m_nextBase, std::nullopt);
    m_room = makeSpace(m_session, m_type, m_base);
    m_head.reset(); // the last pose is in the old room space
    return true;
}

void Spaces::recentre(const Pose& head)
{
    Pose level = levelBelow(head);
    if (m_type == XR_REFERENCE_SPACE_TYPE_LOCAL)
        level.position.y() = head.position.y() - eyeHeight;
    m_nextBase = m_base * level;
}
} // namespace vr
