#pragma once

#include "core/io/document_metadata.h"

#include <chrono>
#include <optional>

namespace app
{
/// Measures the work done by hand: finished strokes, and the time between them. A pause of more than `maxPause` and the
/// time before the first stroke do not count. Belongs to one document.
class WorkTimer
{
public:
    static constexpr std::chrono::nanoseconds maxPause = std::chrono::minutes(3);

    /// Counts a stroke that ends at the time `now`, ns of any clock that never goes back.
    void count(core::WorkDone& work, std::int64_t now)
    {
        const std::chrono::nanoseconds pause(now - m_last.value_or(now));
        if (pause <= maxPause)
            work.seconds += std::chrono::duration<double>(pause).count();
        ++work.strokes;
        m_last = now;
    }

private:
    std::optional<std::int64_t> m_last; ///< end of the last stroke, ns
};
} // namespace app
