#pragma once

namespace core
{
/// Priorities below that of threads that the user waits for, where the system supports them.
enum class ThreadPriority {
    Batch, ///< normal share of a processor, but never preempts another thread
    Idle   ///< as Batch, with a tenth of the processor share
};
/// Lowers the priority of the calling thread until it ends. No effect outside Linux.
void lowerThreadPriority(ThreadPriority priority);
} // namespace core
