#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <string>

namespace simulator
{
/// Returns the enumerator's own name. A value without a name gets the specification's placeholder, such as
/// XR_UNKNOWN_SUCCESS_77.
std::string nameOf(XrResult result);
std::string nameOf(XrStructureType type);
std::string nameOf(XrSessionState state);

std::optional<XrResult> resultNamed(const std::string& name);
} // namespace simulator
