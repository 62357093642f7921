#include "core/util/thread_priority.h"

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace core
{
#ifdef __linux__
/// Sets SCHED_BATCH, without which a waking thread preempts one that has run for long, such as the sculpting thread:
/// sched(7).
void lowerThreadPriority(ThreadPriority priority)
{
    constexpr int idleNice = 10; // a tenth of the processor share at nice 0
    const sched_param none{};
    ::sched_setscheduler(0, SCHED_BATCH, &none);
    if (priority == ThreadPriority::Idle)
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), idleNice);
}
#else
void lowerThreadPriority(ThreadPriority) {}
#endif
} // namespace core
