#include "vr/simulator/attached_action.h"
#include "vr/simulator/calls.h"

#include <cctype>

namespace simulator
{
namespace
{
void requireAttached(const Session& session)
{
    require(session.input.isAttached(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
}

template <class State>
ActionState readState(Call& call, XrSession handle, const XrActionStateGetInfo* info, State* state)
{
    constexpr bool isBool = std::is_same_v<State, XrActionStateBoolean>,
                   isFloat = std::is_same_v<State, XrActionStateFloat>;
    constexpr bool isVector = std::is_same_v<State, XrActionStateVector2f>;
    const Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_ACTION_STATE_GET_INFO);
    validated(state, isBool     ? XR_TYPE_ACTION_STATE_BOOLEAN
                     : isFloat  ? XR_TYPE_ACTION_STATE_FLOAT
                     : isVector ? XR_TYPE_ACTION_STATE_VECTOR2F
                                : XR_TYPE_ACTION_STATE_POSE);
    constexpr XrActionType type = isBool     ? XR_ACTION_TYPE_BOOLEAN_INPUT
                                  : isFloat  ? XR_ACTION_TYPE_FLOAT_INPUT
                                  : isVector ? XR_ACTION_TYPE_VECTOR2F_INPUT
                                             : XR_ACTION_TYPE_POSE_INPUT;
    const Action& action = attachedAction(call, session, {info->action, info->subactionPath, type});
    const ActionState read = session.isFocused() ? session.input.state(action, info->subactionPath) : ActionState();
    state->isActive = read.isActive ? XR_TRUE : XR_FALSE;
    if constexpr (isBool || isFloat || isVector) {
        state->changedSinceLastSync = read.isChanged ? XR_TRUE : XR_FALSE;
        state->lastChangeTime = read.changedAt;
    }
    call.line.update({{"action", action.name}, {"active", read.isActive}, {"value", {read.x, read.y}}});
    return read;
}

/// Returns the action set and the hands for which the client wants it.
ActiveSet checkedSet(Call& call, const Session& session, const XrActiveActionSet& asked)
{
    const auto& set = call.get<ActionSet>(asked.actionSet);
    require(session.input.has(set), XR_ERROR_ACTIONSET_NOT_ATTACHED, "an action set is not attached");
    if (asked.subactionPath == XR_NULL_PATH)
        return {&set};
    const Paths& paths = session.instance().paths;
    const std::string& path = paths.text(asked.subactionPath);
    const bool isDeclared = std::any_of(set.actions.begin(), set.actions.end(), [&](const auto& action) {
        return std::find(action->subactions.begin(), action->subactions.end(), asked.subactionPath) !=
               action->subactions.end();
    });
    require(isDeclared, XR_ERROR_PATH_UNSUPPORTED, "no action of the set has this subaction path");
    return {&set, {path == userPath(Hand::Left), path == userPath(Hand::Right)}};
}

std::vector<ActiveSet> checkedSets(Call& call, const Session& session, const XrActionsSyncInfo& info)
{
    std::vector<ActiveSet> active;
    for (std::uint32_t i = 0; i < info.countActiveActionSets; ++i)
        active.push_back(checkedSet(call, session, (&validated(info.activeActionSets))[i]));
    return active;
}

bool isUserPath(std::string_view path)
{
    return path == userPath(Hand::Left) || path == userPath(Hand::Right) || path == "/user/head" ||
           path == "/user/gamepad" || path == "/user/treadmill";
}

/// Returns the name of a component with a capital: "Trackpad" for "/user/hand/left/input/trackpad/x".
std::string componentName(std::string_view path)
{
    constexpr std::string_view before = "put/"; // end of "input/" and of "output/"
    const std::size_t start = path.find(before) + before.size();
    std::string name(path.substr(start, path.find('/', start) - start));
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

const SessionInput::Binding* bindingAt(const Session& session, const std::string& path)
{
    const auto& bindings = session.input.bindings();
    const auto found =
        std::find_if(bindings.begin(), bindings.end(), [&](const auto& it) { return it.source.path == path; });
    return found == bindings.end() ? nullptr : &*found;
}

std::string localizedName(const Session& session, const Source& source, XrInputSourceLocalizedNameFlags parts)
{
    std::string name;
    const auto add = [&](XrInputSourceLocalizedNameFlags part, std::string_view text) {
        if ((parts & part) != 0)
            name.append(name.empty() ? "" : " ").append(text);
    };
    add(XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT, source.hand == Hand::Left ? "Left Hand" : "Right Hand");
    add(XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT, session.input.profile(source.hand)->name);
    add(XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT, componentName(source.path));
    return name;
}
} // namespace

const Action& attachedAction(Call& call, const Session& session, const ActionQuery& query)
{
    const auto& action = call.get<Action>(query.action);
    require(session.input.has(action), XR_ERROR_ACTIONSET_NOT_ATTACHED, "the action's set is not attached");
    require(action.type == query.type, XR_ERROR_ACTION_TYPE_MISMATCH, "the action is of another type");
    requireSubaction(session.instance().paths, action, query.subaction);
    return action;
}

XrResult attachSessionActionSets(Call& call, XrSession handle, const XrSessionActionSetsAttachInfo* info)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    require(info->countActionSets > 0, XR_ERROR_VALIDATION_FAILURE, "no action sets");
    require(!session.input.isAttached(), XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "action sets are attached once");
    std::vector<std::shared_ptr<ActionSet>> sets;
    for (std::uint32_t i = 0; i < info->countActionSets; ++i)
        sets.push_back(call.runtime.handles.get<ActionSet>((&validated(info->actionSets))[i]));
    session.input.attach(std::move(sets));
    return XR_SUCCESS;
}

XrResult getCurrentInteractionProfile(Call& call, XrSession handle, XrPath userPathNumber,
                                      XrInteractionProfileState* state)
{
    Session& session = call.get<Session>(handle);
    validated(state, XR_TYPE_INTERACTION_PROFILE_STATE);
    requireAttached(session);
    Paths& paths = session.instance().paths;
    const std::string path = paths.text(userPathNumber);
    require(isUserPath(path), XR_ERROR_PATH_UNSUPPORTED, "no top level user path");
    state->interactionProfile = XR_NULL_PATH;
    for (const Hand hand : hands) {
        const Profile* profile = session.input.profile(hand);
        if (path == userPath(hand) && profile)
            state->interactionProfile = paths.number(std::string(profile->path));
    }
    return XR_SUCCESS;
}

XrResult syncActions(Call& call, XrSession handle, const XrActionsSyncInfo* info)
{
    Session& session = call.get<Session>(handle);
    const SimulatedWorld& world = call.runtime.world;
    validated(info, XR_TYPE_ACTIONS_SYNC_INFO);
    const std::vector<ActiveSet> active = checkedSets(call, session, *info);
    if (!session.isFocused()) {
        session.input.deactivate();
        return XR_SESSION_NOT_FOCUSED;
    }
    if (session.input.chooseProfiles(world, session.instance().suggestions))
        session.instance().events.push(
            XrEventDataInteractionProfileChanged{XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED, nullptr, handle});
    session.input.sync(world, session.instance().paths, active);
    return XR_SUCCESS;
}

XrResult getActionStateBoolean(Call& call, XrSession handle, const XrActionStateGetInfo* info,
                               XrActionStateBoolean* state)
{
    const ActionState read = readState(call, handle, info, state);
    state->currentState = read.x != 0 ? XR_TRUE : XR_FALSE;
    return XR_SUCCESS;
}

XrResult getActionStateFloat(Call& call, XrSession handle, const XrActionStateGetInfo* info, XrActionStateFloat* state)
{
    state->currentState = static_cast<float>(readState(call, handle, info, state).x);
    return XR_SUCCESS;
}

XrResult getActionStateVector2f(Call& call, XrSession handle, const XrActionStateGetInfo* info,
                                XrActionStateVector2f* state)
{
    const ActionState read = readState(call, handle, info, state);
    state->currentState = {static_cast<float>(read.x), static_cast<float>(read.y)};
    return XR_SUCCESS;
}

XrResult getActionStatePose(Call& call, XrSession handle, const XrActionStateGetInfo* info, XrActionStatePose* state)
{
    readState(call, handle, info, state);
    return XR_SUCCESS;
}

XrResult enumerateBoundSourcesForAction(Call& call, XrSession handle, const XrBoundSourcesForActionEnumerateInfo* info,
                                        std::uint32_t capacity, std::uint32_t* count, XrPath* sources)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_BOUND_SOURCES_FOR_ACTION_ENUMERATE_INFO);
    const auto& action = call.get<Action>(info->action);
    require(session.input.has(action), XR_ERROR_ACTIONSET_NOT_ATTACHED, "the action's set is not attached");
    std::vector<XrPath> found;
    for (const auto& binding : session.input.bindings()) {
        if (binding.action.get() == &action)
            found.push_back(session.instance().paths.number(binding.source.path));
    }
    writeItems(OutputArray<XrPath>{capacity, count, sources}, found);
    return XR_SUCCESS;
}

XrResult getInputSourceLocalizedName(Call& call, XrSession handle, const XrInputSourceLocalizedNameGetInfo* info,
                                     std::uint32_t capacity, std::uint32_t* count, char* buffer)
{
    constexpr XrInputSourceLocalizedNameFlags known = XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT |
                                                      XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT |
                                                      XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT;
    const Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_INPUT_SOURCE_LOCALIZED_NAME_GET_INFO);
    requireAttached(session);
    const bool isKnown = info->whichComponents != 0 && (info->whichComponents & ~known) == 0;
    require(isKnown, XR_ERROR_VALIDATION_FAILURE, "no part of the name, or an unknown one");
    const auto* binding = bindingAt(session, session.instance().paths.text(info->sourcePath));
    require(binding, XR_ERROR_PATH_UNSUPPORTED, "not a source that something is bound to");
    writeText({capacity, count, buffer}, localizedName(session, binding->source, info->whichComponents));
    return XR_SUCCESS;
}
} // namespace simulator
