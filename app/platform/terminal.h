#pragma once

#include <QStringList>

#include <cstdio>
#include <filesystem>

namespace app
{
/// Returns whether the stream is connected to a terminal.
bool isTerminal(std::FILE* stream);

/// Makes the standard streams carry bytes as they are. Windows would otherwise turn each line feed that is written into
/// two characters; other systems have no other streams. Precondition: nothing was read or written yet. Thread: main.
void useBinaryStreams();

/// Makes the texts of this process and its children UTF-8. Elsewhere than on Windows it switches from the locale C to
/// C.UTF-8. Qt does the same, but since Qt 6.8 only after four lines of warning on stderr. Other locales stay as they
/// are, because they name the user's language. On Windows it switches the console until the program ends, and lets it
/// obey control sequences. Precondition: no Qt application exists yet, and endOnInterrupt() was called. Thread: main.
void useUtf8();

/// Returns the arguments of the program without its name. Precondition: those of main().
QStringList programArguments(int argc, char* argv[]);

/// Returns one argument of the program as a path, with exactly the name that the system has. Precondition: those of
/// main(), and 0 <= index < argc.
std::filesystem::path argumentPath(char* argv[], int index);
} // namespace app
