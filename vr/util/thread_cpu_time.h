#pragma once

namespace vr
{
/// Returns the CPU time that the calling thread has used, in milliseconds. Cost: a fraction of a microsecond.
double threadCpuMilliseconds();

/// Adds up the CPU time that a thread spends in OpenGL draw calls. A driver without a graphics card rasterises within
/// them.
class DrawCallTimer
{
public:
    template <class Draw> void run(const Draw& draw)
    {
        const double start = threadCpuMilliseconds();
        draw();
        m_milliseconds += threadCpuMilliseconds() - start;
        ++m_calls;
    }

    double milliseconds() const { return m_milliseconds; }
    unsigned long calls() const { return m_calls; }

private:
    double m_milliseconds = 0;
    unsigned long m_calls = 0;
};
} // namespace vr
