// Steps of xrSyncActions: find the active bindings, whose set is active, whose wand is on, and whose source is used by
// no set of higher priority; combine the bindings of each action; compare the result with the last one.
#include "vr/simulator/session_input.h"

#include "vr/simulator/instance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulator
{
namespace
{
const ActionSet& setOf(const Action& action)
{
    return static_cast<const ActionSet&>(*action.parent);
}

bool isHeard(const SessionInput::Binding& binding, const SimulatedWorld& world, const std::vector<ActiveSet>& active)
{
    const auto hand = static_cast<std::size_t>(binding.source.hand);
    return world.wands[hand].isOn && std::any_of(active.begin(), active.end(), [&](const ActiveSet& it) {
               return it.set == &setOf(*binding.action) && it.isFor[hand];
           });
}

/// Returns whether one path is the other or its parent: such paths share values.
bool overlap(const std::string& a, const std::string& b)
{
    const auto contains = [](const std::string& parent, const std::string& child) {
        return child.starts_with(parent) && (child.size() == parent.size() || child[parent.size()] == '/');
    };
    return contains(a, b) || contains(b, a);
}

double reading(const Wand& wand, const Source& source, XrActionType type, XrTime time)
{
    const double value = wand.value(source.x, time);
    const bool isPressed = value >= source.threshold;
    const bool isSwitch = source.kind == Source::Kind::Boolean || type == XR_ACTION_TYPE_BOOLEAN_INPUT;
    return isSwitch ? (isPressed ? 1 : 0) : value;
}

/// Combines a binding into the action's state. The source with the greatest value counts; of poses the first one.
void combine(ActionState& state, const SessionInput::Binding& binding, const SimulatedWorld& world)
{
    const Source& source = binding.source;
    const Wand& wand = world.wands[static_cast<std::size_t>(source.hand)];
    const double x = reading(wand, source, binding.action->type, world.now);
    const double y = source.kind == Source::Kind::Vector ? wand.value(source.y, world.now) : 0;
    if (!state.isActive || std::hypot(x, y) > std::hypot(state.x, state.y)) {
        state.x = x;
        state.y = y;
    }
    if (!state.pose && isPose(source.kind))
        state.pose = source;
    state.isActive = true;
}

void compare(ActionState& state, const ActionState& before, XrTime now)
{
    const bool differs = state.x != before.x || state.y != before.y;
    state.isChanged = state.isActive && before.isActive && differs;
    if (state.isActive)
        state.changedAt = before.isActive && !differs ? before.changedAt : now;
}
} // namespace

bool SessionInput::has(const ActionSet& set) const
{
    return std::any_of(m_sets.begin(), m_sets.end(), [&](const auto& it) { return it.get() == &set; });
}

bool SessionInput::has(const Action& action) const
{
    return has(setOf(action));
}

void SessionInput::attach(std::vector<std::shared_ptr<ActionSet>> sets)
{
    m_sets = std::move(sets);
    for (const auto& set : m_sets)
        set->isAttached = true;
}

bool SessionInput::chooseProfiles(const SimulatedWorld& world, const Suggestions& suggestions)
{
    std::array<const Profile*, hands.size()> chosen{};
    const auto suggested = suggestions.find(world.profile);
    for (std::size_t hand = 0; hand < hands.size() && suggested != suggestions.end(); ++hand)
        chosen[hand] = world.wands[hand].isOn ? profileAt(world.profile) : nullptr;
    if (std::exchange(m_profiles, chosen) == chosen)
        return false;
    m_bindings.clear();
    if (suggested == suggestions.end())
        return true;
    for (const auto& [action, path] : suggested->second) {
        const auto source = sourceAt(*profileAt(world.profile), path, action->type);
        if (source && profile(source->hand) && has(*action))
            m_bindings.push_back({action, *source});
    }
    return true;
}

std::vector<const SessionInput::Binding*> SessionInput::activeBindings(const SimulatedWorld& world,
                                                                       const std::vector<ActiveSet>& active) const
{
    std::vector<const Binding*> candidates, found;
    for (const Binding& binding : m_bindings) {
        if (isHeard(binding, world, active))
            candidates.push_back(&binding);
    }
    const auto isTaken = [&](const Binding* binding) {
        return std::any_of(candidates.begin(), candidates.end(), [&](const Binding* other) {
            return setOf(*other->action).priority > setOf(*binding->action).priority &&
                   overlap(other->source.path, binding->source.path);
        });
    };
    std::remove_copy_if(candidates.begin(), candidates.end(), std::back_inserter(found), isTaken);
    return found;
}

void SessionInput::sync(const SimulatedWorld& world, const Paths& paths, const std::vector<ActiveSet>& active)
{
    const std::map<Key, ActionState> before = std::exchange(m_states, {});
    for (const Binding* binding : activeBindings(world, active)) {
        const Action& action = *binding->action;
        combine(m_states[{&action, XR_NULL_PATH}], *binding, world);
        const XrPath hand = paths.known(userPath(binding->source.hand));
        if (std::find(action.subactions.begin(), action.subactions.end(), hand) != action.subactions.end())
            combine(m_states[{&action, hand}], *binding, world);
    }
    for (auto& [key, state] : m_states) {
        const auto old = before.find(key);
        compare(state, old == before.end() ? ActionState() : old->second, world.now);
    }
}

ActionState SessionInput::state(const Action& action, XrPath subaction) const
{
    const auto found = m_states.find({&action, subaction});
    return found == m_states.end() ? ActionState() : found->second;
}
} // namespace simulator
