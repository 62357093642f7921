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
    std::vector<std::string> command; ///< the program's path first
    std::chrono::seconds time{0};     ///< by the clock; then it is killed
    std::uint64_t maxBytes = 0;       ///< of its answer; with more it is killed
    std::stop_token stop = {};        ///< then it is killed, within some 20 ms
};

struct ChildResult
{
    enum class End { Exited, Died, TooSlow, Stopped, NotStarted };
    End end = End::Exited;
    std::string bytes; ///< from its standard output
};

/// The path of this program, whatever has become of its file.
std::string ownProgram();

/// Runs a program whose input is empty and whose errors nobody reads, and waits for it; it is gone afterwards. Any
/// thread.
ChildResult runChild(const ChildRequest& request);
} // namespace app
