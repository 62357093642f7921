#include "app/platform/process_usage.h"

#include <sys/resource.h>
#include <time.h>

namespace app
{
double threadCpuMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double peakRssMb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    constexpr double unitsPerMb = 1 << 20; // macOS reports ru_maxrss in bytes
#else
    constexpr double unitsPerMb = 1 << 10; // Linux reports ru_maxrss in KiB
#endif
    return static_cast<double>(usage.ru_maxrss) / unitsPerMb;
}
} // namespace app
