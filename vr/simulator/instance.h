#pragma once

#include "vr/simulator/handles.h"
#include "vr/simulator/paths.h"
#include "vr/simulator/profiles.h"

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace simulator
{
class Action;
class ActionSet;

/// A queue of events that the client has not polled yet.
class Events
{
public:
    template <class Event> void push(const Event& event)
    {
        static_assert(sizeof(Event) <= sizeof(XrEventDataBuffer));
        XrEventDataBuffer buffer{};
        std::memcpy(&buffer, &event, sizeof event);
        m_waiting.push_back(buffer);
    }

    std::optional<XrEventDataBuffer> take();
    /// Discards the waiting events, except changes of a session's state. The client gets an event that reports the
    /// loss.
    void lose();
    /// Removes the events about a session.
    void drop(XrSession session);

private:
    std::deque<XrEventDataBuffer> m_waiting;
};

struct SuggestedBinding
{
    std::shared_ptr<Action> action;
    std::string path;
};

class Instance : public Object
{
public:
    /// Returns whether the client may suggest bindings for the profile: its version of OpenXR, or an extension that it
    /// has enabled, defines the profile.
    bool knows(const Profile& profile) const
    {
        const bool isCore = profile.coreMinor && *profile.coreMinor <= static_cast<int>(XR_VERSION_MINOR(apiVersion));
        return isCore || extensions.contains(profile.extension);
    }

    Paths paths;
    Events events;
    XrVersion apiVersion = 0;                      ///< version that the client asked for
    std::set<std::string, std::less<>> extensions; ///< extensions that the client has enabled
    bool requirementsAsked = false;
    std::optional<std::int64_t> lostAt; ///< frame of the session in which the instance is lost
    /// Sets of the instance; those whose handles are destroyed are included, because their bindings live on.
    std::vector<std::shared_ptr<ActionSet>> actionSets;
    std::map<std::string, std::vector<SuggestedBinding>> suggestions; ///< indexed by profile
};
} // namespace simulator
