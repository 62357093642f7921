#pragma once

#include "vr/simulator/motion.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <vector>

namespace simulator
{
class Runtime;

/// What a script changes at one moment. Movements begin at `start`.
using Change = std::function<void(Runtime&, XrTime start)>;
using ScriptStep = std::vector<Change>;

/// Throws std::runtime_error that says what is not understood. The vocabulary is in control_api.h.
ScriptStep readStep(const nlohmann::json& json);
} // namespace simulator
