#pragma once

#include "vr/simulator/profiles.h"
#include "vr/simulator/script_step.h"

namespace simulator
{
/// Number of frames that a movement takes; 0: it happens at once.
using Over = std::int64_t;

/// Returns the changes that a step makes to the head, or to a wand. Throws as readStep().
Change headChange(const nlohmann::json& value, Over over);
Change wandChange(const nlohmann::json& value, Over over, Hand hand);
} // namespace simulator
