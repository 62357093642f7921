// Source: Microsoft Learn, "Console Virtual Terminal Sequences", "SetConsoleOutputCP function".
#include "app/platform/terminal.h"

#include <fcntl.h>
#include <io.h>

#include <cstdlib>
#include <memory>
#include <windows.h>

#include <shellapi.h>

namespace app
{
namespace
{
HANDLE consoleOf(std::FILE* stream)
{
    return reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream)));
}

/// State of the console before this program changed it. The console belongs to the shell that started the program.
struct ConsoleState
{
    UINT output = GetConsoleOutputCP(), input = GetConsoleCP(); ///< code pages; 0: there is no console
};

ConsoleState& formerState()
{
    static ConsoleState state;
    return state;
}

void restoreConsole()
{
    SetConsoleOutputCP(formerState().output);
    SetConsoleCP(formerState().input);
}

/// Takes Ctrl+C and the like before the handler that ends the program: the last one that was set is called first.
BOOL WINAPI restoreAtInterrupt(DWORD)
{
    restoreConsole();
    return FALSE;
}

/// The arguments of the process in UTF-16, its name first. main() has them in the code page of the user, which lacks
/// most characters.
struct WideArguments
{
    int count = 0;
    std::unique_ptr<wchar_t*, decltype(&LocalFree)> words{CommandLineToArgvW(GetCommandLineW(), &count), LocalFree};
};

const WideArguments& wideArguments()
{
    static const WideArguments arguments;
    return arguments;
}
} // namespace

/// NUL is no terminal, although it is a character device as the console is.
bool isTerminal(std::FILE* stream)
{
    DWORD mode = 0;
    return GetConsoleMode(consoleOf(stream), &mode) != 0;
}

void useBinaryStreams()
{
    for (std::FILE* const stream : {stdin, stdout, stderr})
        _setmode(_fileno(stream), _O_BINARY);
}

void useUtf8()
{
    if (formerState().output == 0)
        return;
    SetConsoleOutputCP(CP_UTF8);
    SetConsoleCP(CP_UTF8);
    std::atexit(restoreConsole);
    SetConsoleCtrlHandler(restoreAtInterrupt, TRUE);
    for (std::FILE* const stream : {stdout, stderr}) {
        DWORD mode = 0;
        if (GetConsoleMode(consoleOf(stream), &mode))
            SetConsoleMode(consoleOf(stream), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
}

QStringList programArguments(int, char*[])
{
    QStringList arguments;
    for (int i = 1; i < wideArguments().count; ++i)
        arguments << QString::fromWCharArray(wideArguments().words.get()[i]);
    return arguments;
}

std::filesystem::path argumentPath(char*[], int index)
{
    return wideArguments().words.get()[index];
}
} // namespace app
