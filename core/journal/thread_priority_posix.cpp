#include "core/journal/thread_priority.h"

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace core
{
#ifdef __linux__
/// A thread that wakes otherwise takes the processor of one that has run long, which is the sculptor's: sched(7).
void lowerThreadPriority(ThreadPriority priority)
{
    constexpr int idleNice = 10; // a tenth of the share of one that is not nice
    const sched_param none{};
    ::sched_setscheduler(0, SCHED_BATCH, &none);
    if (priority == ThreadPriority::Idle)
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), idleNice);
}
#else
void lowerThreadPriority(ThreadPriority) {}
#endif
} // namespace core
