#pragma once

#include <functional>
#include <stop_token>

namespace core
{
/// Progress and cancellation of a long job. A job that was cancelled has changed nothing.
struct JobControl
{
    std::stop_token stop;
    std::function<void(double share)> progress; ///< 0 to 1, growing; called on the job's thread; may be empty

    bool isCancelled() const { return stop.stop_requested(); }
    void reportProgress(double share) const
    {
        if (progress)
            progress(share);
    }
    /// For a part of the job that takes it from one share to another.
    JobControl part(double from, double to) const
    {
        if (!progress)
            return {stop, {}};
        return {stop, [from, to, whole = progress](double share) { whole(from + share * (to - from)); }};
    }
};
} // namespace core
