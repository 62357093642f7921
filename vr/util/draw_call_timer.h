#pragma once

#include "core/util/thread_cpu_time.h"

namespace vr
{
/// Adds up the CPU time that a thread spends in OpenGL draw calls. A driver without a graphics card rasterises within
/// them.
class DrawCallTimer
{
public:
    template <class Draw> void run(const Draw& draw)
    {
        const double start = core::threadCpuMs();
        draw();
        m_milliseconds += core::threadCpuMs() - start;
        ++m_calls;
    }

    double milliseconds() const { return m_milliseconds; }
    unsigned long calls() const { return m_calls; }

private:
    double m_milliseconds = 0;
    unsigned long m_calls = 0;
};
} // namespace vr
