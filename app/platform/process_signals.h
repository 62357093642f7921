#pragma once

namespace app
{
/// Makes exceeding the system's file size limit a write error instead of a signal that ends the program.
void surviveFileSizeLimit();

/// Makes a write to a closed pipe or socket an error (EPIPE) instead of a signal that ends the program. The window
/// needs this, because the client library of an OpenXR runtime may write to a service that has died. Commands keep the
/// default, so that `fettle ... | head` ends quietly.
void surviveBrokenPipes();

/// Makes Ctrl+C end the program at once, without any of its code running. That is what signals do by default; Windows
/// would first end libraries while threads use them. Unsaved work is in the journal.
void endOnInterrupt();
} // namespace app
