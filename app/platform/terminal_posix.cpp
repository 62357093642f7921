#include "app/platform/terminal.h"

#include <unistd.h>

namespace app
{
bool isTerminal(std::FILE* stream)
{
    return isatty(fileno(stream)) != 0;
}
} // namespace app
