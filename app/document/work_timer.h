#pragma once

#include "core/io/document_metadata.h"

#include <chrono>
#include <optional>

namespace app
{
/// Counts what is done by hand: each finished stroke, and the time from one to the next. A pause of more than
/// `maxPause` does not count at all, nor does the time before the first stroke. A value of one document; any clock that
/// never goes back.
class WorkTimer
{
public:
    static constexpr std::chrono::nanoseconds maxPause = std::chrono::minutes(3);

    /// A stroke ended now, ns.
    void count(core::WorkDone& work, std::int64_t now)
    {
        const std::chrono::nanoseconds pause(now - m_last.value_or(now));
        if (pause <= maxPause)
            work.seconds += std::chrono::duration<double>(pause).count();
        ++work.strokes;
        m_last = now;
    }

private:
    std::optional<std::int64_t> m_last; ///< end of a stroke, ns
};
} // namespace app
