// Source: Microsoft Learn, "HandlerRoutine callback function".
#include "app/platform/process_signals.h"

#include <windows.h>

namespace app
{
namespace
{
constexpr UINT interrupted = 0xC000013A; ///< STATUS_CONTROL_C_EXIT, by which a shell knows the reason

/// Takes Ctrl+C, Ctrl+Break, and the closing of the console. The end of the session comes to a window as
/// WM_QUERYENDSESSION, which Qt answers. Thread: one that the system makes.
BOOL WINAPI endAtOnce(DWORD)
{
    return TerminateProcess(GetCurrentProcess(), interrupted);
}
} // namespace

/// Does nothing: Windows has no file size limit. A full quota is a write error.
void surviveFileSizeLimit() {}

/// Does nothing: on Windows a write to a closed pipe or socket is an error (ERROR_NO_DATA, WSAECONNRESET), and there is
/// no signal.
void surviveBrokenPipes() {}

void endOnInterrupt()
{
    SetConsoleCtrlHandler(endAtOnce, TRUE);
}
} // namespace app
