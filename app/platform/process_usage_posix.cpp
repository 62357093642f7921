#include "app/platform/process_usage.h"

#include <sys/resource.h>

namespace app
{
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
