#pragma once

namespace ui
{
/// From now on this thread gets what the others leave, as far as the system knows such a thing.
void yieldToOthers();
} // namespace ui
