#pragma once

#include "vr/simulator/call.h"

namespace simulator
{
struct ActionQuery
{
    XrAction action = XR_NULL_HANDLE;
    XrPath subaction = XR_NULL_PATH;
    XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT; ///< that it must have
};

/// Fails unless it is attached to the session, of that type, and has that subaction path.
const Action& attachedAction(Call& call, const Session& session, const ActionQuery& query);
} // namespace simulator
