#pragma once

#include <QString>

#include <cstdint>

/// What a run by hand asks of a test, as in FETTLE_SEED=7.
inline std::uint64_t numberFromEnvironment(const char* name, std::uint64_t otherwise)
{
    bool isNumber = false;
    const std::uint64_t value = qEnvironmentVariable(name).toULongLong(&isNumber);
    return isNumber ? value : otherwise;
}
