#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <string>

namespace simulator
{
/// Returns the enumerator's own name. A result or structure type without a name gets the specification's placeholder,
/// such as XR_UNKNOWN_SUCCESS_77; other values without a name get their number.
std::string nameOf(XrResult result);
std::string nameOf(XrStructureType type);
std::string nameOf(XrSessionState state);
std::string nameOf(XrEnvironmentBlendMode mode);

std::optional<XrResult> resultNamed(const std::string& name);
} // namespace simulator
