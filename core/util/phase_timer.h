#pragma once

#include <chrono>

namespace core
{
/// Adds the wall time of its scope to a phase, less what another phase took inside it.
class PhaseTimer
{
public:
    explicit PhaseTimer(double& milliseconds) : m_milliseconds(milliseconds) {}
    /// `inner`: a running total of milliseconds that counts elsewhere.
    PhaseTimer(double& milliseconds, const double& inner)
        : m_milliseconds(milliseconds)
        , m_inner(&inner)
        , m_before(inner)
    {}
    ~PhaseTimer()
    {
        m_milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - m_start).count();
        if (m_inner)
            m_milliseconds -= *m_inner - m_before;
    }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    double& m_milliseconds;
    const double* m_inner = nullptr;
    double m_before = 0;
    Clock::time_point m_start = Clock::now();
};
} // namespace core
