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

/// Does nothing: SIGINT, SIGTERM and SIGHUP have this effect.
void endOnInterrupt() {}
} // namespace app
