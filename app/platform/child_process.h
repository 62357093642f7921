#pragma once

#include <chrono>
#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace app
{
struct ChildRequest
{
    /// Path of the program, then its arguments; on Windows in UTF-8.
    std::vector<std::string> command;
    std::chrono::seconds time{0}; ///< wall-clock limit; the child is killed when it is exceeded
    std::uint64_t maxBytes = 0;   ///< limit of the standard output in bytes; the child is killed when it is exceeded
    std::stop_token stop = {};    ///< kills the child within about 20 ms
};

struct ChildResult
{
    enum class End { Exited, Died, TooSlow, Stopped, NotStarted };
    End end = End::Exited;
    std::string bytes; ///< content of the standard output
};

/// Returns a path that starts this program. On Linux it works even if the program's file was moved or deleted.
std::string ownProgram();

/// Runs a program with empty standard input, discards its standard error, and waits until it has ended. Thread: any.
ChildResult runChild(const ChildRequest& request);
} // namespace app
