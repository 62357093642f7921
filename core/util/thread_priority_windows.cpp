// Source: Microsoft Learn, "Scheduling Priorities", "Priority Boosts".
#include "core/util/thread_priority.h"

#include <windows.h>

namespace core
{
/// Switches off the boost of a thread that wakes, by which it preempts one of its own priority that has run for long,
/// such as the sculpting thread. Batch keeps the normal priority: threads below it get nothing for seconds while all
/// processors are busy.
void lowerThreadPriority(ThreadPriority priority)
{
    const HANDLE thread = GetCurrentThread();
    SetThreadPriorityBoost(thread, TRUE);
    if (priority == ThreadPriority::Idle)
        SetThreadPriority(thread, THREAD_PRIORITY_LOWEST);
}
} // namespace core
