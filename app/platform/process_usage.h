#pragma once

namespace app
{
/// CPU time of the calling thread since it began, milliseconds.
double threadCpuMs();
/// The most memory that the process ever held, MiB (2^20 bytes).
double peakRssMb();
} // namespace app
