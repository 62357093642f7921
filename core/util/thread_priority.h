#pragma once

namespace core
{
/// Priorities below that of threads that the user waits for, where the system supports them.
enum class ThreadPriority {
    Batch, ///< normal share of a processor, but never preempts another thread
    Idle   ///< as Batch, with a tenth of the processor share; on Windows with what other threads leave
};
/// Lowers the priority of the calling thread until it ends. No effect on other systems than Linux and Windows.
void lowerThreadPriority(ThreadPriority priority);
} // namespace core
