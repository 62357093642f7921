#pragma once

namespace vr
{
/// From now on the process gives no freed memory back to the system. Any thread.
///
/// For Mesa's software renderer: when a buffer or a picture is written, it looks whether any context of the process still draws with it, and
/// asks their threads nothing. It reads lists that one of them may just have freed (llvmpipe_flush_resource of 22.3), and the window draws
/// beside the headset's thread. Graphics cards' drivers do not need it.
void keepFreedMemory();
} // namespace vr
