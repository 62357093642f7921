#pragma once

#include <cstdio>

namespace app
{
/// Whether a person at a terminal reads what is written there.
bool isTerminal(std::FILE* stream);
} // namespace app
