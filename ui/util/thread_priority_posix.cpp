#include "ui/util/thread_priority.h"

#include <sys/resource.h>

namespace ui
{
/// On Linux a thread has a niceness of its own; elsewhere it is the process's, which stays.
void lowerThreadPriority()
{
#ifdef __linux__
    constexpr int niceness = 10;
    setpriority(PRIO_PROCESS, 0, niceness);
#endif
}
} // namespace ui
