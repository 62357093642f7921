#include "core/util/system_code.h"

#include <cerrno>

namespace core
{
int systemCodeOf(const std::error_code& problem)
{
    return problem.value();
}

bool isSystemCode(int systemCode, std::errc meaning)
{
    return std::error_code(systemCode, std::generic_category()) == meaning;
}

void clearStreamCode()
{
    errno = 0;
}

int streamCode()
{
    return errno;
}
} // namespace core
