#include "vr/simulator/attached_action.h"
#include "vr/simulator/calls.h"

namespace simulator
{
namespace
{
std::vector<Hand> handsOf(const Session& session, const Action& action, XrPath subaction)
{
    std::vector<Hand> found;
    for (const auto& binding : session.input.bindings()) {
        const bool isAsked =
            subaction == XR_NULL_PATH || session.instance().paths.known(userPath(binding.source.hand)) == subaction;
        if (binding.action.get() == &action && isAsked)
            found.push_back(binding.source.hand);
    }
    return found;
}

const Action& hapticAction(Call& call, const Session& session, const XrHapticActionInfo& info)
{
    return attachedAction(call, session, {info.action, info.subactionPath, XR_ACTION_TYPE_VIBRATION_OUTPUT});
}

void checkPulse(Call& call, const XrHapticVibration& pulse)
{
    if (!(pulse.amplitude >= 0 && pulse.amplitude <= 1))
        call.error("an amplitude is not from 0 to 1");
    if (pulse.duration <= 0 && pulse.duration != XR_MIN_HAPTIC_DURATION)
        call.error("a pulse has no duration");
    if (!(pulse.frequency >= 0))
        call.error("a frequency is negative");
}

nlohmann::json described(Call& call, Hand hand, const XrHapticVibration* pulse)
{
    nlohmann::json haptic = call.where();
    haptic["hand"] = hand == Hand::Left ? "left" : "right";
    if (pulse)
        haptic.update(
            {{"amplitude", pulse->amplitude}, {"frequency", pulse->frequency}, {"duration_ns", pulse->duration}});
    else
        haptic["stop"] = true;
    return haptic;
}
} // namespace

XrResult applyHapticFeedback(Call& call, XrSession handle, const XrHapticActionInfo* info,
                             const XrHapticBaseHeader* feedback)
{
    const Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_HAPTIC_ACTION_INFO);
    const Action& action = hapticAction(call, session, *info);
    validated(feedback);
    require(feedback->type == XR_TYPE_HAPTIC_VIBRATION, XR_ERROR_VALIDATION_FAILURE, "no such haptic feedback");
    const auto& pulse = reinterpret_cast<const XrHapticVibration&>(*feedback);
    checkPulse(call, pulse);
    if (!session.isFocused())
        return XR_SESSION_NOT_FOCUSED;
    for (const Hand hand : handsOf(session, action, info->subactionPath))
        call.runtime.log.haptic(described(call, hand, &pulse));
    return XR_SUCCESS;
}

XrResult stopHapticFeedback(Call& call, XrSession handle, const XrHapticActionInfo* info)
{
    const Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_HAPTIC_ACTION_INFO);
    const Action& action = hapticAction(call, session, *info);
    if (!session.isFocused())
        return XR_SESSION_NOT_FOCUSED;
    for (const Hand hand : handsOf(session, action, info->subactionPath))
        call.runtime.log.haptic(described(call, hand, nullptr));
    return XR_SUCCESS;
}
} // namespace simulator
