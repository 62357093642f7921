#include "app/platform/terminal.h"

#include <clocale>
#include <cstdlib>
#include <langinfo.h>
#include <string_view>
#include <unistd.h>

namespace app
{
bool isTerminal(std::FILE* stream)
{
    return isatty(fileno(stream)) != 0;
}

void useUtf8Locale()
{
    std::setlocale(LC_CTYPE, "");
    if (std::string_view(nl_langinfo(CODESET)) == "UTF-8")
        return;
    const char* const all = std::getenv("LC_ALL"); // overrides LC_CTYPE if it is not empty
    setenv(all && *all ? "LC_ALL" : "LC_CTYPE", "C.UTF-8", 1);
}
} // namespace app
