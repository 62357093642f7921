#pragma once

namespace core
{
/// Returns the CPU time that the calling thread has used, milliseconds. Cost: a fraction of a microsecond.
double threadCpuMs();
} // namespace core
