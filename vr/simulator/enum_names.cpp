#include "vr/simulator/enum_names.h"

#include <openxr/openxr_reflection.h>

namespace simulator
{
namespace
{
struct NamedResult
{
    const char* name;
    XrResult result;
};

#define FETTLE_NAMED(NAME, VALUE) {#NAME, NAME},
constexpr NamedResult namedResults[] = {XR_LIST_ENUM_XrResult(FETTLE_NAMED)};
#undef FETTLE_NAMED
} // namespace

std::string nameOf(XrResult result)
{
    for (const NamedResult& named : namedResults) {
        if (named.result == result)
            return named.name;
    }
    return (XR_SUCCEEDED(result) ? "XR_UNKNOWN_SUCCESS_" : "XR_UNKNOWN_FAILURE_") +
           std::to_string(static_cast<int>(result));
}

#define FETTLE_CASE(NAME, VALUE)                                                                                       \
    case NAME:                                                                                                         \
        return #NAME;

std::string nameOf(XrStructureType type)
{
    switch (type) {
        XR_LIST_ENUM_XrStructureType(FETTLE_CASE) default : return "XR_UNKNOWN_STRUCTURE_TYPE_" +
                                                            std::to_string(static_cast<int>(type));
    }
}

std::string nameOf(XrSessionState state)
{
    switch (state) {
        XR_LIST_ENUM_XrSessionState(FETTLE_CASE) default : return std::to_string(static_cast<int>(state));
    }
}

std::string nameOf(XrEnvironmentBlendMode mode)
{
    switch (mode) {
        XR_LIST_ENUM_XrEnvironmentBlendMode(FETTLE_CASE) default : return std::to_string(static_cast<int>(mode));
    }
}
#undef FETTLE_CASE

std::optional<XrResult> resultNamed(const std::string& name)
{
    for (const NamedResult& named : namedResults) {
        if (name == named.name)
            return named.result;
    }
    return {};
}
} // namespace simulator
