#pragma once

namespace app
{
/// Returns the peak resident memory of the process, MiB (2^20 bytes).
double peakRssMb();
} // namespace app
