#pragma once

#include <cstdio>

namespace app
{
/// Returns whether a terminal shows what is written to the stream.
bool isTerminal(std::FILE* stream);
} // namespace app
