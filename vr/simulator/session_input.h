#pragma once

#include "vr/simulator/actions.h"
#include "vr/simulator/profiles.h"
#include "vr/simulator/simulated_world.h"

#include <map>

namespace simulator
{
struct SuggestedBinding;

/// The state of an action, for one subaction path or for all.
struct ActionState
{
    bool isActive = false;
    double x = 0, y = 0; ///< value of the action; a boolean is 0 or 1
    bool isChanged = false;
    XrTime changedAt = 0;
    std::optional<Source> pose; ///< source of a pose action
};

/// An action set that xrSyncActions reads, and for which hands.
struct ActiveSet
{
    const ActionSet* set = nullptr;
    std::array<bool, hands.size()> isFor{true, true};
};

/// The action sets of one session, their bindings, and their states at the last xrSyncActions.
class SessionInput
{
public:
    using Suggestions = std::map<std::string, std::vector<SuggestedBinding>>;

    struct Binding
    {
        std::shared_ptr<Action> action;
        Source source;
    };

    bool isAttached() const { return !m_sets.empty(); }
    bool has(const Action& action) const;
    bool has(const ActionSet& set) const;
    void attach(std::vector<std::shared_ptr<ActionSet>> sets);

    /// Chooses the profile of each hand, if the client has suggested bindings for it. Returns whether a profile has
    /// changed.
    bool chooseProfiles(const SimulatedWorld& world, const Suggestions& suggestions);
    const Profile* profile(Hand hand) const { return m_profiles[static_cast<std::size_t>(hand)]; }
    const std::vector<Binding>& bindings() const { return m_bindings; }

    void sync(const SimulatedWorld& world, const Paths& paths, const std::vector<ActiveSet>& active);
    /// Makes all actions inactive.
    void deactivate() { m_states.clear(); }
    ActionState state(const Action& action, XrPath subaction) const;
    std::optional<Source> poseSource(const Action& action, XrPath subaction) const
    {
        return state(action, subaction).pose;
    }

private:
    struct Key
    {
        const Action* action = nullptr;
        XrPath subaction = XR_NULL_PATH;
        friend auto operator<=>(const Key&, const Key&) = default;
    };

    std::vector<const Binding*> activeBindings(const SimulatedWorld& world, const std::vector<ActiveSet>& active) const;

    std::vector<std::shared_ptr<ActionSet>> m_sets;
    std::array<const Profile*, hands.size()> m_profiles{};
    std::vector<Binding> m_bindings;
    std::map<Key, ActionState> m_states;
};
} // namespace simulator
