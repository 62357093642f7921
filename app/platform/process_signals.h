#pragma once

namespace app
{
/// A file that would grow past what the system allows is from now on an error of writing, not the end of the program.
void surviveFileSizeLimit();
} // namespace app
