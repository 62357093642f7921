#pragma once

#include "vr/simulator/handles.h"
#include "vr/simulator/paths.h"

#include <string>
#include <vector>

namespace simulator
{
class Action : public Object
{
public:
    std::string name, localizedName;
    XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
    std::vector<XrPath> subactions;
};

class ActionSet : public Object
{
public:
    std::string name, localizedName;
    std::uint32_t priority = 0;
    bool isAttached = false;                      ///< attached to a session, so that the set can no longer change
    std::vector<std::shared_ptr<Action>> actions; ///< actions of the set, including those whose handles are destroyed
};

/// Fails unless `subaction` is null or one of the paths that the action was created with.
void requireSubaction(const Paths& paths, const Action& action, XrPath subaction);
} // namespace simulator
