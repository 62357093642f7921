#pragma once

#include <functional>
#include <stop_token>

namespace core
{
/// Progress and cancellation of a long job. A cancelled job leaves its input unchanged.
struct JobControl
{
    std::stop_token stop;
    /// Reports progress from 0 to 1, ascending. May be empty. Thread: the job's.
    std::function<void(double share)> progress;

    bool isCancelled() const { return stop.stop_requested(); }
    void reportProgress(double share) const
    {
        if (progress)
            progress(share);
    }
    /// Returns a control for a part of the job, whose progress 0 to 1 is mapped to [from, to].
    JobControl part(double from, double to) const
    {
        if (!progress)
            return {stop, {}};
        return {stop, [from, to, whole = progress](double share) { whole(from + share * (to - from)); }};
    }
};
} // namespace core
