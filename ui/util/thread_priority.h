#pragma once

namespace ui
{
/// Lowers the calling thread's scheduling priority (Linux: nice 10; elsewhere no effect).
void lowerThreadPriority();
} // namespace ui
