#pragma once

namespace app
{
/// Returns the CPU time of the calling thread since it began, milliseconds.
double threadCpuMs();
/// Returns the peak resident memory of the process, MiB (2^20 bytes).
double peakRssMb();
} // namespace app
