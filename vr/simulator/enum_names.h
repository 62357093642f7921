#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <string>

namespace simulator
{
/// The enumerators' own names; without one the specification's stand-in, as XR_UNKNOWN_SUCCESS_77.
std::string nameOf(XrResult result);
std::string nameOf(XrStructureType type);
std::string nameOf(XrSessionState state);

std::optional<XrResult> resultNamed(const std::string& name);
} // namespace simulator
