#pragma once

#include "vr/simulator/call.h"

namespace simulator
{
struct ActionQuery
{
    XrAction action = XR_NULL_HANDLE;
    XrPath subaction = XR_NULL_PATH;
    XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT; ///< type that the action must have
};

/// Returns the action. Fails unless it is attached to the session and has the type and the subaction path of the query.
const Action& attachedAction(Call& call, const Session& session, const ActionQuery& query);
} // namespace simulator
