#pragma once

#include <chrono>

namespace core
{
/// Adds the wall time of its scope to a phase's total, minus the time that a phase inside the scope counts for itself.
class PhaseTimer
{
public:
    explicit PhaseTimer(double& milliseconds) : m_milliseconds(milliseconds) {}
    /// `inner`: running total of milliseconds of a phase inside this scope; its increase is subtracted.
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
