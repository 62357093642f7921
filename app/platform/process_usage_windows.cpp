#include "app/platform/process_usage.h"

#include <windows.h>

#include <psapi.h>

namespace app
{
double peakRssMb()
{
    PROCESS_MEMORY_COUNTERS counters{};
    K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return static_cast<double>(counters.PeakWorkingSetSize) / (1 << 20);
}
} // namespace app
