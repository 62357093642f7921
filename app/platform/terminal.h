#pragma once

#include <cstdio>

namespace app
{
/// Returns whether the stream is connected to a terminal.
bool isTerminal(std::FILE* stream);
} // namespace app
