#include "app/classroom/classroom_turn.h"

namespace app
{
TurnRecord joined(const TurnRecord& before, const TurnRecord& after)
{
    if (!before || !after)
        return std::nullopt;
    std::vector<core::FileEntry> both = *before;
    both.insert(both.end(), after->begin(), after->end());
    return both;
}
} // namespace app
