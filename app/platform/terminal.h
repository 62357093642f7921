#pragma once

#include <cstdio>

namespace app
{
/// Returns whether the stream is connected to a terminal.
bool isTerminal(std::FILE* stream);

/// Switches this process and its children from the locale C to C.UTF-8. Qt does the same, but since Qt 6.8 only after
/// four lines of warning on stderr. Other locales stay as they are, because they name the user's language.
/// Precondition: no Qt application exists yet. Thread: main.
void useUtf8Locale();
} // namespace app
