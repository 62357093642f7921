#pragma once

#include "vr/simulator/motion.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <vector>

namespace simulator
{
class Runtime;

/// A change that a script makes at one moment. Movements begin at `start`.
using Change = std::function<void(Runtime&, XrTime start)>;
using ScriptStep = std::vector<Change>;

/// Reads a step in the vocabulary of control_api.h. Throws std::runtime_error that names the part that is not
/// understood.
ScriptStep readStep(const nlohmann::json& json);
} // namespace simulator
