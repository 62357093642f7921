#pragma once

#include <functional>
#include <stop_token>

namespace core
{
/// How a long piece of work is watched: it says how far it is, and is told to stop. A job that was stopped has changed nothing.
struct JobWatch
{
    std::stop_token stop;
    std::function<void(double share)> progress; ///< 0 to 1, growing; called on the job's thread; may be empty

    bool stopped() const { return stop.stop_requested(); }
    void reached(double share) const
    {
        if (progress)
            progress(share);
    }
    /// For a part of the job that takes it from one share to another.
    JobWatch part(double from, double to) const
    {
        if (!progress)
            return {stop, {}};
        return {stop, [from, to, whole = progress](double share) { whole(from + share * (to - from)); }};
    }
};
} // namespace core
