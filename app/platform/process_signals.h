#pragma once

namespace app
{
/// A file that would grow past what the system allows is from now on an error of writing, not the end of the program.
void surviveFileSizeLimit();

/// Makes a write to a closed pipe or socket an error (EPIPE) instead of the end of the program. For the window: the
/// client library of an OpenXR runtime may write to its service after that has died. Commands keep the default, so that
/// `fettle ... | head` ends quietly.
void surviveBrokenPipes();
} // namespace app
