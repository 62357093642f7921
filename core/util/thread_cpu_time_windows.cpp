#include "core/util/thread_cpu_time.h"

#include <cstdint>
#include <windows.h>

namespace core
{
namespace
{
double milliseconds(const FILETIME& time)
{
    constexpr double perMillisecond = 1e4; // the unit is 100 ns
    return static_cast<double>(std::uint64_t(time.dwHighDateTime) << 32 | time.dwLowDateTime) / perMillisecond;
}
} // namespace

/// Windows counts this time in steps of up to 16 ms, so only differences of seconds are exact.
double threadCpuMs()
{
    FILETIME begin{}, end{}, system{}, user{};
    GetThreadTimes(GetCurrentThread(), &begin, &end, &system, &user);
    return milliseconds(system) + milliseconds(user);
}
} // namespace core
