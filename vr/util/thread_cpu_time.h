#pragma once

namespace vr
{
/// The CPU time that this thread has used, in milliseconds. Costs a fraction of a microsecond.
double threadCpuMilliseconds();

/// Adds up the CPU time of calls into OpenGL that draw: a driver without a graphics card shades pictures within them.
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
