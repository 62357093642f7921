#include "app/platform/process_usage.h"

#include <cstdint>
#include <windows.h>

#include <psapi.h>

namespace app
{
namespace
{
double milliseconds(const FILETIME& time)
{
    constexpr double perMs = 1e4; // the unit is 100 ns
    return static_cast<double>(std::uint64_t(time.dwHighDateTime) << 32 | time.dwLowDateTime) / perMs;
}
} // namespace

/// Windows counts this time in steps of up to 16 ms.
double threadCpuMs()
{
    FILETIME begin{}, end{}, system{}, user{};
    GetThreadTimes(GetCurrentThread(), &begin, &end, &system, &user);
    return milliseconds(system) + milliseconds(user);
}

double peakRssMb()
{
    PROCESS_MEMORY_COUNTERS counters{};
    K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return static_cast<double>(counters.PeakWorkingSetSize) / (1 << 20);
}
} // namespace app
