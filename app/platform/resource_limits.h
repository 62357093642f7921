#pragma once

#include <cstdint>

namespace app
{
/// For a process that reads what strangers wrote: from now on it has that many bytes beyond what it has now (at most
/// what the machine has) and that many seconds of the processor, cannot write files, leaves no core file, ends with its
/// parent, and, where the system can do that, starts no other program and opens no connection. Only standard input,
/// output and error stay open.
void limitOwnProcess(std::uint64_t memory, std::uint64_t seconds);
} // namespace app
