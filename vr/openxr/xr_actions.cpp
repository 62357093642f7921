#include "vr/openxr/xr_actions.h"

#include "vr/openxr/xr_convert.h"

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
template <std::size_t N> void copyText(const QByteArray& text, char (&to)[N])
{
    std::strncpy(to, text.constData(), N - 1);
}

XrDuration nanoseconds(double seconds)
{
    return seconds > 0 ? static_cast<XrDuration>(std::llround(seconds * 1e9)) : XR_MIN_HAPTIC_DURATION;
}

/// Returns the profile with this path; null: Fettle has no such profile.
const WandProfile* profileOf(const std::string& path)
{
    const auto found = std::ranges::find(wandProfiles(), path, &WandProfile::path);
    return found == wandProfiles().end() ? nullptr : &*found;
}

bool has(const WandProfile& profile, Control control)
{
    return std::ranges::any_of(profile.bindings, [&](const Binding& binding) { return binding.control == control; });
}
} // namespace

/// Makes the action set and its actions, suggests bindings and attaches the set. Once it is attached, OpenXR accepts no
/// more actions or suggestions.
Actions::Actions(const Instance& instance, XrSession session) : m_instance(instance), m_session(session)
{
    for (std::size_t side = 0; side < sideCount; ++side)
        m_hands[side].path = instance.path(handPaths[side]);
    makeActions();
    for (const WandProfile& profile : wandProfiles())
        if (instance.knows(profile))
            suggest(profile);
    attach();
    for (Hand& hand : m_hands) {
        hand.grip = makeSpace(Control::Grip, hand.path);
        hand.aim = makeSpace(Control::Aim, hand.path);
        hand.pinch = makeSpace(Control::Pinch, hand.path);
    }
}

/// Returns the name that the runtime shows where users rebind parts of their wands. OpenXR requires all names to
/// differ.
QString Actions::nameOf(Control control)
{
    switch (control) {
    case Control::Grip:
        return tr("Hand");
    case Control::Aim:
        return tr("Pointing");
    case Control::Trigger:
        return tr("Trigger");
    case Control::Pad:
        return tr("Pad");
    case Control::PadTouch:
        return tr("Pad touched");
    case Control::PadPress:
        return tr("Pad pressed");
    case Control::Side:
        return tr("Side button");
    case Control::Menu:
        return tr("Menu button");
    case Control::Pulse:
        return tr("Buzz");
    case Control::Pinch:
        return tr("Pinch");
    }
    return {};
}

void Actions::makeActions()
{
    XrActionSetCreateInfo setInfo{};
    setInfo.type = XR_TYPE_ACTION_SET_CREATE_INFO;
    copyText("sculpting", setInfo.actionSetName);
    copyText(tr("Sculpting").toUtf8(), setInfo.localizedActionSetName);
    XrActionSet set = XR_NULL_HANDLE;
    check(xrCreateActionSet(m_instance.handle(), &setInfo, &set), "xrCreateActionSet");
    m_set = ActionSetHandle(set);

    const std::array<XrPath, sideCount> hands{m_hands[0].path, m_hands[1].path};
    for (std::size_t control = 0; control < controlCount; ++control) {
        XrActionCreateInfo info{};
        info.type = XR_TYPE_ACTION_CREATE_INFO;
        copyText(controlKinds[control].name, info.actionName);
        copyText(nameOf(static_cast<Control>(control)).toUtf8(), info.localizedActionName);
        info.actionType = controlKinds[control].type;
        info.countSubactionPaths = static_cast<std::uint32_t>(hands.size());
        info.subactionPaths = hands.data();
        XrAction made = XR_NULL_HANDLE;
        check(xrCreateAction(set, &info, &made), "xrCreateAction");
        m_actions[control] = ActionHandle(made);
    }
}

/// Suggests the bindings of one kind of wand. Each kind has a call of its own: a runtime that refuses one kind may
/// accept the next.
void Actions::suggest(const WandProfile& profile)
{
    std::vector<XrActionSuggestedBinding> bindings;
    for (const Binding& binding : profile.bindings) {
        const std::array<const char*, sideCount> parts{binding.left, binding.right};
        for (std::size_t side = 0; side < sideCount; ++side)
            if (parts[side])
                bindings.push_back(
                    {action(binding.control), m_instance.path((std::string(handPaths[side]) + parts[side]).c_str())});
    }
    const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr,
                                                    m_instance.path(profile.path),
                                                    static_cast<std::uint32_t>(bindings.size()), bindings.data()};
    const XrResult result = xrSuggestInteractionProfileBindings(m_instance.handle(), &info);
    if (XR_FAILED(result)) // a fatal error is reported by the next call
        m_refused << QLatin1StringView(profile.path) + QStringLiteral(": ") + resultName(result);
}

void Actions::attach()
{
    XrActionSet set = m_set.get();
    const XrSessionActionSetsAttachInfo info{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set};
    check(xrAttachSessionActionSets(m_session, &info), "xrAttachSessionActionSets");
}

SpaceHandle Actions::makeSpace(Control control, XrPath hand) const
{
    const XrActionSpaceCreateInfo info{XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, action(control), hand, toXr({})};
    XrSpace made = XR_NULL_HANDLE;
    check(xrCreateActionSpace(m_session, &info, &made), "xrCreateActionSpace");
    return SpaceHandle(made);
}

Wands Actions::read(XrSpace room, XrTime time, bool hasFocus)
{
    const bool hasButtons = hasFocus && sync();
    for (std::size_t side = 0; side < sideCount; ++side) {
        WandState rest;
        rest.grip = m_wands[side].grip;
        rest.aim = m_wands[side].aim;
        rest.pinch = m_wands[side].pinch;
        rest.isStick = m_hands[side].isStick;
        rest.isSimple = m_hands[side].isSimple;
        rest.isHand = m_hands[side].isHand;
        m_wands[side] = rest;
        readPoses(side, room, time);
        if (hasButtons)
            readButtons(side);
        m_hands[side].isSqueezed = m_wands[side].side;
    }
    return m_wands;
}

/// Returns whether the runtime has updated the buttons. The focus may be lost before the runtime reports the change.
bool Actions::sync()
{
    const XrActiveActionSet active{m_set.get(), XR_NULL_PATH};
    const XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
    return check(xrSyncActions(m_session, &info), "xrSyncActions") != XR_SESSION_NOT_FOCUSED;
}

void Actions::readPoses(std::size_t side, XrSpace room, XrTime time)
{
    WandState& wand = m_wands[side];
    const auto read = [&](const SpaceHandle& space, Pose& pose) {
        XrSpaceLocation location{};
        location.type = XR_TYPE_SPACE_LOCATION;
        check(xrLocateSpace(space.get(), room, time, &location), "xrLocateSpace");
        if (isValid(location))
            pose = fromXr(location.pose);
        return isTracked(location);
    };
    const bool hasGrip = read(m_hands[side].grip, wand.grip);
    const bool hasAim = read(m_hands[side].aim, wand.aim);
    const bool hasTip = !wand.isHand || read(m_hands[side].pinch, wand.pinch);
    wand.isTracked = hasGrip && hasAim && hasTip;
}

XrActionStateGetInfo Actions::stateGetInfo(Control control, std::size_t side) const
{
    return {XR_TYPE_ACTION_STATE_GET_INFO, nullptr, action(control), m_hands[side].path};
}

bool Actions::isPressed(Control control, std::size_t side) const
{
    const XrActionStateGetInfo info = stateGetInfo(control, side);
    XrActionStateBoolean state{};
    state.type = XR_TYPE_ACTION_STATE_BOOLEAN;
    check(xrGetActionStateBoolean(m_session, &info, &state), "xrGetActionStateBoolean");
    return state.isActive && state.currentState;
}

/// Returns the value of a trigger or grip, 0 to 1. A plain button reports 1 or 0; a missing control reports 0.
double Actions::amountOf(Control control, std::size_t side) const
{
    const XrActionStateGetInfo info = stateGetInfo(control, side);
    XrActionStateFloat state{};
    state.type = XR_TYPE_ACTION_STATE_FLOAT;
    check(xrGetActionStateFloat(m_session, &info, &state), "xrGetActionStateFloat");
    return state.isActive ? static_cast<double>(state.currentState) : 0;
}

void Actions::readButtons(std::size_t side)
{
    WandState& wand = m_wands[side];
    const XrActionStateGetInfo triggerInfo = stateGetInfo(Control::Trigger, side),
                               padInfo = stateGetInfo(Control::Pad, side);
    XrActionStateFloat trigger{};
    trigger.type = XR_TYPE_ACTION_STATE_FLOAT;
    check(xrGetActionStateFloat(m_session, &triggerInfo, &trigger), "xrGetActionStateFloat");
    wand.isActive = trigger.isActive;
    if (!wand.isActive)
        return;
    XrActionStateVector2f pad{};
    pad.type = XR_TYPE_ACTION_STATE_VECTOR2F;
    check(xrGetActionStateVector2f(m_session, &padInfo, &pad), "xrGetActionStateVector2f");
    wand.trigger = trigger.currentState;
    if (pad.isActive)
        wand.pad = {pad.currentState.x, pad.currentState.y};
    wand.padTouched = isPressed(Control::PadTouch, side);
    wand.padPressed = isPressed(Control::PadPress, side);
    wand.squeeze = amountOf(Control::Side, side);
    wand.side = wand.squeeze >= (m_hands[side].isSqueezed ? squeezeRelease : squeezePress);
    wand.menu = isPressed(Control::Menu, side);
}

void Actions::pulse(const HapticPulse& pulse)
{
    XrHapticVibration vibration{};
    vibration.type = XR_TYPE_HAPTIC_VIBRATION;
    vibration.duration = nanoseconds(pulse.seconds);
    vibration.frequency = pulse.frequency > 0 ? static_cast<float>(pulse.frequency) : XR_FREQUENCY_UNSPECIFIED;
    vibration.amplitude = static_cast<float>(std::clamp(pulse.amplitude, 0.0, 1.0));
    const XrHapticActionInfo info{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, action(Control::Pulse),
                                  m_hands[static_cast<std::size_t>(pulse.side)].path};
    check(xrApplyHapticFeedback(m_session, &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)),
          "xrApplyHapticFeedback");
}

void Actions::refreshProfiles()
{
    for (Hand& hand : m_hands) {
        XrInteractionProfileState state{};
        state.type = XR_TYPE_INTERACTION_PROFILE_STATE;
        check(xrGetCurrentInteractionProfile(m_session, hand.path, &state), "xrGetCurrentInteractionProfile");
        if (state.interactionProfile == XR_NULL_PATH)
            continue; // nothing is held, perhaps only because a hand is lost for a moment
        const WandProfile* profile = profileOf(m_instance.text(state.interactionProfile));
        hand.isStick = profile && profile->isStick;
        hand.isHand = profile && has(*profile, Control::Pinch);
        hand.isSimple = profile && !hand.isHand && !has(*profile, Control::Pad);
    }
}
} // namespace vr
