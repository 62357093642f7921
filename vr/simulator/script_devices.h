#pragma once

#include "vr/simulator/profiles.h"
#include "vr/simulator/script_step.h"

namespace simulator
{
/// A movement takes that many frames; 0: it is there at once.
using Over = std::int64_t;

/// What a step says of the head, and of a wand. These throw as readStep().
Change headChange(const nlohmann::json& value, Over over);
Change wandChange(const nlohmann::json& value, Over over, Hand hand);
} // namespace simulator
