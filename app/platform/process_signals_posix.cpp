#include "app/platform/process_signals.h"

#include <csignal>

namespace app
{
void surviveFileSizeLimit()
{
    std::signal(SIGXFSZ, SIG_IGN);
}

void surviveBrokenPipes()
{
    std::signal(SIGPIPE, SIG_IGN);
}
} // namespace app
