#pragma once

#include "vr/simulator/handles.h"
#include "vr/simulator/paths.h"

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace simulator
{
class Action;
class ActionSet;

/// What has happened and was not told yet.
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
    /// Loses the events that wait, but for a session's states, and the client is told that some were.
    void lose();
    /// Those that tell of it.
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
    Paths paths;
    Events events;
    XrVersion apiVersion = 0;                      ///< the client asked for it
    std::set<std::string, std::less<>> extensions; ///< that the client enabled
    bool requirementsAsked = false;
    std::optional<std::int64_t> lostAt;                 ///< frame of the session
    std::vector<std::shared_ptr<ActionSet>> actionSets; ///< also those whose handles are destroyed: bindings live on
    std::map<std::string, std::vector<SuggestedBinding>> suggestions; ///< by profile
};
} // namespace simulator
