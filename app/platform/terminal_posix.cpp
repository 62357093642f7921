#include "app/platform/terminal.h"

#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace app
{
bool isTerminal(std::FILE* stream)
{
    return isatty(fileno(stream)) != 0;
}

void useBinaryStreams() {}

void useUtf8()
{
    constexpr const char* utf8 = "C.UTF-8";
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) { // in the order of precedence
        const char* const variable = std::getenv(name);
        const std::string_view locale(variable ? variable : "");
        if (locale.empty())
            continue;
        if (locale == "C" || locale == "POSIX")
            setenv(name == std::string_view("LANG") ? "LC_CTYPE" : name, utf8, 1);
        return;
    }
    setenv("LC_CTYPE", utf8, 1);
}

QStringList programArguments(int argc, char* argv[])
{
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return arguments;
}

std::filesystem::path argumentPath(char* argv[], int index)
{
    return argv[index];
}
} // namespace app
