#pragma once

namespace core
{
/// How far a thread stays behind those that people wait for, where the system can do that; else nothing happens.
enum class ThreadPriority {
    Batch, ///< its share of a processor, but it takes none from a thread that runs
    Idle   ///< what others leave, and a little more
};
/// Of the calling thread, for good.
void lowerThreadPriority(ThreadPriority priority);
} // namespace core
