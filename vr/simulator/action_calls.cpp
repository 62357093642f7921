#include "vr/simulator/actions.h"
#include "vr/simulator/calls.h"

namespace simulator
{
namespace
{
constexpr std::array<std::string_view, 5> userPaths{"/user/hand/left", "/user/hand/right", "/user/head",
                                                    "/user/gamepad", "/user/treadmill"};

struct Names
{
    std::string_view name, localized;
};

void checkNames(const Names& names)
{
    require(!names.name.empty(), XR_ERROR_NAME_INVALID, "the name is empty");
    require(Paths::isLevel(names.name), XR_ERROR_PATH_FORMAT_INVALID, "the name could not stand in a path");
    require(!names.localized.empty(), XR_ERROR_LOCALIZED_NAME_INVALID, "the localized name is empty");
}

/// Fails if one of the names is taken by one of `others`, whose handles are alive.
template <class Items> void checkUnique(const Names& names, const Items& others)
{
    for (const auto& other : others) {
        require(other->name != names.name, XR_ERROR_NAME_DUPLICATED, "the name is taken");
        require(other->localizedName != names.localized, XR_ERROR_LOCALIZED_NAME_DUPLICATED,
                "the localized name is taken");
    }
}

template <std::size_t N> std::string_view bounded(const char (&text)[N])
{
    return {text, strnlen(text, N)};
}

bool isActionType(XrActionType type)
{
    switch (type) {
    case XR_ACTION_TYPE_BOOLEAN_INPUT:
    case XR_ACTION_TYPE_FLOAT_INPUT:
    case XR_ACTION_TYPE_VECTOR2F_INPUT:
    case XR_ACTION_TYPE_POSE_INPUT:
    case XR_ACTION_TYPE_VIBRATION_OUTPUT:
        return true;
    default:
        return false;
    }
}

std::vector<XrPath> checkedSubactions(const Paths& paths, const XrActionCreateInfo& info)
{
    std::vector<XrPath> subactions;
    for (std::uint32_t i = 0; i < info.countSubactionPaths; ++i) {
        const XrPath path = (&validated(info.subactionPaths))[i];
        const bool isUser = std::find(userPaths.begin(), userPaths.end(), paths.text(path)) != userPaths.end();
        const bool isNew = std::find(subactions.begin(), subactions.end(), path) == subactions.end();
        require(isUser && isNew, XR_ERROR_PATH_UNSUPPORTED,
                "a subaction path is twice there, or no top level user path");
        subactions.push_back(path);
    }
    return subactions;
}

/// Warns of a binding that would be ignored silently.
void warnOfLostBinding(Call& call, const Paths& paths, const Action& action, const Source* source)
{
    if (!source) {
        call.warn(action.name + " is bound to something that it cannot be converted from");
        return;
    }
    const XrPath hand = paths.known(userPath(source->hand));
    const bool isOfHand =
        std::find(action.subactions.begin(), action.subactions.end(), hand) != action.subactions.end();
    if (!action.subactions.empty() && !isOfHand)
        call.warn(action.name + " is bound to a hand that is not among its subaction paths");
}

SuggestedBinding checkedBinding(Call& call, const Instance& instance, const Profile& profile,
                                const XrActionSuggestedBinding& suggested)
{
    const auto& action = call.get<Action>(suggested.action);
    const std::string& path = instance.paths.text(suggested.binding);
    require(!static_cast<const ActionSet&>(*action.parent).isAttached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
            "the action set is attached");
    require(hasPath(profile, path), XR_ERROR_PATH_UNSUPPORTED, "the profile has no such path");
    const auto source = sourceAt(profile, path, action.type);
    if (!profile.components.empty())
        warnOfLostBinding(call, instance.paths, action, source ? &*source : nullptr);
    return {call.runtime.handles.get<Action>(suggested.action), path};
}
} // namespace

void requireSubaction(const Paths& paths, const Action& action, XrPath subaction)
{
    if (subaction == XR_NULL_PATH)
        return;
    paths.text(subaction);
    const bool isDeclared =
        std::find(action.subactions.begin(), action.subactions.end(), subaction) != action.subactions.end();
    require(isDeclared, XR_ERROR_PATH_UNSUPPORTED, "the action was not created with this subaction path");
}

XrResult createActionSet(Call& call, XrInstance handle, const XrActionSetCreateInfo* info, XrActionSet* out)
{
    Instance& instance = call.get<Instance>(handle);
    validated(info, XR_TYPE_ACTION_SET_CREATE_INFO);
    validated(out);
    const Names names{bounded(info->actionSetName), bounded(info->localizedActionSetName)};
    checkNames(names);
    checkUnique(names, call.runtime.handles.childrenOf<ActionSet>(instance));
    const auto set = std::make_shared<ActionSet>();
    set->name = names.name;
    set->localizedName = names.localized;
    set->priority = info->priority;
    instance.actionSets.push_back(set);
    *out = call.runtime.handles.add<XrActionSet>(set, &instance);
    return XR_SUCCESS;
}

XrResult destroyActionSet(Call& call, XrActionSet handle)
{
    call.runtime.handles.destroy(*call.runtime.handles.find<ActionSet>(handle));
    return XR_SUCCESS;
}

XrResult createAction(Call& call, XrActionSet handle, const XrActionCreateInfo* info, XrAction* out)
{
    auto& set = call.get<ActionSet>(handle);
    const auto& instance = static_cast<const Instance&>(*set.parent);
    validated(info, XR_TYPE_ACTION_CREATE_INFO);
    validated(out);
    require(!set.isAttached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "the action set is attached");
    const Names names{bounded(info->actionName), bounded(info->localizedActionName)};
    checkNames(names);
    checkUnique(names, call.runtime.handles.childrenOf<Action>(set));
    require(isActionType(info->actionType), XR_ERROR_VALIDATION_FAILURE, "no such type of action");
    const auto action = std::make_shared<Action>();
    action->name = names.name;
    action->localizedName = names.localized;
    action->type = info->actionType;
    action->subactions = checkedSubactions(instance.paths, *info);
    set.actions.push_back(action);
    *out = call.runtime.handles.add<XrAction>(action, &set);
    return XR_SUCCESS;
}

XrResult destroyAction(Call& call, XrAction handle)
{
    call.runtime.handles.destroy(*call.runtime.handles.find<Action>(handle));
    return XR_SUCCESS;
}

XrResult suggestInteractionProfileBindings(Call& call, XrInstance handle,
                                           const XrInteractionProfileSuggestedBinding* suggestion)
{
    Instance& instance = call.get<Instance>(handle);
    validated(suggestion, XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    const std::string& path = instance.paths.text(suggestion->interactionProfile);
    const Profile* profile = profileAt(path);
    require(profile && instance.knows(*profile), XR_ERROR_PATH_UNSUPPORTED, "no such interaction profile here");
    require(suggestion->countSuggestedBindings > 0, XR_ERROR_VALIDATION_FAILURE, "no bindings");
    std::vector<SuggestedBinding> bindings;
    for (std::uint32_t i = 0; i < suggestion->countSuggestedBindings; ++i)
        bindings.push_back(checkedBinding(call, instance, *profile, (&validated(suggestion->suggestedBindings))[i]));
    instance.suggestions[path] = std::move(bindings);
    call.line.update({{"profile", path}, {"bindings", suggestion->countSuggestedBindings}});
    return XR_SUCCESS;
}
} // namespace simulator
