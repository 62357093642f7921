#pragma once

#include <cstdint>

namespace app
{
/// Restricts this process for reading files from untrusted sources. It gets `memory` bytes beyond its present use (at
/// most the machine's memory) and `seconds` of CPU time. It cannot write data to files and leaves no core file. On
/// Linux it also ends with its parent, starts no other program, opens no connection, and keeps only standard input,
/// output and error open. On Windows it starts no other program and sends at most a byte a second over a network; the
/// user's folders made for untrusted programs (AppData/LocalLow) stay writable, and runChild() sees to the rest.
void limitOwnProcess(std::uint64_t memory, std::uint64_t seconds);
} // namespace app
