#pragma once

namespace core
{
/// Priority below threads that the user waits for, where the system supports it.
enum class ThreadPriority {
    Batch, ///< its share of a processor, but it preempts no other thread
    Idle   ///< as Batch, with a tenth of the share
};
/// Lowers the priority of the calling thread until it ends. No effect outside Linux.
void lowerThreadPriority(ThreadPriority priority);
} // namespace core
