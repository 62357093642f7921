#pragma once

#include <QString>

#include <cstdint>

/// Returns the number that an environment variable such as FETTLE_SEED=7 sets, or `otherwise`.
inline std::uint64_t numberFromEnvironment(const char* name, std::uint64_t otherwise)
{
    bool isNumber = false;
    const std::uint64_t value = qEnvironmentVariable(name).toULongLong(&isNumber);
    return isNumber ? value : otherwise;
}
