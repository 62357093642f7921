#pragma once

#include "tests/vr/simulator/raw_client.h"

#include <cstring>
#include <string>
#include <utility>

inline constexpr const char* viveProfile = "/interaction_profiles/htc/vive_controller";

/// All flags of a space location.
inline constexpr XrSpaceLocationFlags locatedWholly =
    XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT |
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;

/// A client with one action set.
class RawPlayer : public RawClient
{
public:
    RawPlayer()
    {
        if (createInstance() != XR_SUCCESS || prepare() != XR_SUCCESS)
            qFatal("no session");
        hands = {path("/user/hand/left"), path("/user/hand/right")};
        XrActionSetCreateInfo info{};
        info.type = XR_TYPE_ACTION_SET_CREATE_INFO;
        std::strcpy(info.actionSetName, "play");
        std::strcpy(info.localizedActionSetName, "Play");
        xrCreateActionSet(instance, &info, &set);
    }

    XrPath path(const char* text)
    {
        XrPath found = XR_NULL_PATH;
        xrStringToPath(instance, text, &found);
        return found;
    }

    XrAction action(const char* name, XrActionType type)
    {
        XrActionCreateInfo info{};
        info.type = XR_TYPE_ACTION_CREATE_INFO;
        std::strcpy(info.actionName, name);
        std::strcpy(info.localizedActionName, name);
        info.actionType = type;
        info.countSubactionPaths = static_cast<std::uint32_t>(hands.size());
        info.subactionPaths = hands.data();
        XrAction made = XR_NULL_HANDLE;
        xrCreateAction(set, &info, &made);
        return made;
    }

    /// Suggests bindings for both hands.
    XrResult bind(const char* profile, const std::vector<std::pair<XrAction, const char*>>& inputs)
    {
        std::vector<XrActionSuggestedBinding> bindings;
        for (const auto& [to, input] : inputs) {
            for (const char* hand : {"/user/hand/left", "/user/hand/right"})
                bindings.push_back({to, path((std::string(hand) + input).c_str())});
        }
        const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr,
                                                        path(profile), static_cast<std::uint32_t>(bindings.size()),
                                                        bindings.data()};
        return xrSuggestInteractionProfileBindings(instance, &info);
    }

    XrResult attach()
    {
        const XrSessionActionSetsAttachInfo info{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set};
        return xrAttachSessionActionSets(session, &info);
    }

    /// Submits a frame in which the actions are synced.
    XrResult play()
    {
        XrResult synced = XR_ERROR_RUNTIME_FAILURE;
        if (const XrResult result = frame([&] { synced = sync(); }); XR_FAILED(result))
            return result;
        return synced;
    }

    XrResult sync()
    {
        const XrActiveActionSet active{set, XR_NULL_PATH};
        const XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
        return xrSyncActions(session, &info);
    }

    XrActionStateBoolean boolean(XrAction of, XrPath hand = XR_NULL_PATH)
    {
        return state(xrGetActionStateBoolean, XrActionStateBoolean{XR_TYPE_ACTION_STATE_BOOLEAN, nullptr, 2, 2, 2, 2},
                     of, hand);
    }
    XrActionStateFloat number(XrAction of, XrPath hand = XR_NULL_PATH)
    {
        return state(xrGetActionStateFloat, XrActionStateFloat{XR_TYPE_ACTION_STATE_FLOAT, nullptr, -9, 2, 2, 2}, of,
                     hand);
    }
    XrActionStateVector2f vector(XrAction of, XrPath hand = XR_NULL_PATH)
    {
        return state(xrGetActionStateVector2f,
                     XrActionStateVector2f{XR_TYPE_ACTION_STATE_VECTOR2F, nullptr, {-9, -9}, 2, 2, 2}, of, hand);
    }

    XrSpace handSpace(XrAction of, XrPath hand)
    {
        const XrActionSpaceCreateInfo info{
            XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, of, hand, {{0, 0, 0, 1}, {0, 0, 0}}};
        XrSpace made = XR_NULL_HANDLE;
        xrCreateActionSpace(session, &info, &made);
        return made;
    }

    XrSpace reference(XrReferenceSpaceType type)
    {
        const XrReferenceSpaceCreateInfo info{
            XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, type, {{0, 0, 0, 1}, {0, 0, 0}}};
        XrSpace made = XR_NULL_HANDLE;
        xrCreateReferenceSpace(session, &info, &made);
        return made;
    }

    /// Locates a space at the display time of the last frame.
    XrSpaceLocation locate(XrSpace space, XrSpace base, XrSpaceVelocity* velocity = nullptr)
    {
        XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, velocity, 0, {}};
        xrLocateSpace(space, base, frameState.predictedDisplayTime, &location);
        return location;
    }

    XrActionSet set = XR_NULL_HANDLE;
    std::vector<XrPath> hands;

private:
    template <class Ask, class State> State state(Ask ask, State unset, XrAction of, XrPath hand)
    {
        const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, of, hand};
        ask(session, &info, &unset);
        return unset;
    }
};
