// Sources: Microsoft Learn, "Nested Jobs", "SetProcessMitigationPolicy function",
// JOBOBJECT_NET_RATE_CONTROL_INFORMATION.
//
// Windows has no way for a program to give up the network. An app container has none, but it could not read the user's
// files either, and a rule of the firewall needs an administrator. What remains is the rate limit of a job: one byte a
// second. It does not count what services send for the process, such as questions for the address of a name.
#include "app/platform/resource_limits.h"

#include "app/platform/low_rights_windows.h"

#include "core/util/system_file_windows.h"

#include <algorithm>
#include <bit>
#include <windows.h>

#include <psapi.h>

namespace app
{
namespace
{
/// JOBOBJECT_NET_RATE_CONTROL_INFORMATION, which the headers of MinGW 10 lack.
struct NetRateLimit
{
    std::uint64_t maxBandwidth; ///< outgoing bytes per second
    std::uint32_t flags;
    std::uint8_t dscpTag;
};
constexpr auto netRateClass = std::bit_cast<JOBOBJECTINFOCLASS>(32); ///< JobObjectNetRateControlInformation
constexpr std::uint32_t limitsBandwidth = 0x1 | 0x2; ///< JOB_OBJECT_NET_RATE_CONTROL_ENABLE and _MAX_BANDWIDTH

/// Returns the memory that the process has committed, bytes; 0 if the system does not report it.
std::uint64_t usedNow()
{
    PROCESS_MEMORY_COUNTERS counters{};
    K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return counters.PagefileUsage;
}

std::uint64_t machineMemory()
{
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    GlobalMemoryStatusEx(&status);
    return status.ullTotalPhys;
}

/// Puts this process into a job of its own, inside of the one that ends it with its parent (child_process_windows.cpp).
/// An allocation beyond the limit fails; exceeding the time ends the process. The job lasts as long as the process,
/// which keeps no handle by which it could change the limits.
void enterJob(std::uint64_t memory, std::uint64_t seconds)
{
    const core::ScopedHandle job(CreateJobObjectW(nullptr, nullptr));
    if (!job)
        return;
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    JOBOBJECT_BASIC_LIMIT_INFORMATION& basic = limits.BasicLimitInformation;
    basic.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_PROCESS_TIME |
                       JOB_OBJECT_LIMIT_ACTIVE_PROCESS | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    basic.ActiveProcessLimit = 1;
    constexpr std::uint64_t unitsPerSecond = 10'000'000; // of 100 ns
    basic.PerProcessUserTimeLimit.QuadPart = static_cast<LONGLONG>(seconds * unitsPerSecond);
    limits.ProcessMemoryLimit = usedNow() + std::min(memory, machineMemory());
    SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits);
    NetRateLimit network{1, limitsBandwidth, 0};
    SetInformationJobObject(job.get(), netRateClass, &network, sizeof network);
    AssignProcessToJobObject(job.get(), GetCurrentProcess());
}

/// Forbids what only an attacker would do in this process. Each policy that an older Windows does not know is skipped.
void forbidTricks()
{
    PROCESS_MITIGATION_DYNAMIC_CODE_POLICY code{};
    code.ProhibitDynamicCode = 1;
    SetProcessMitigationPolicy(ProcessDynamicCodePolicy, &code, sizeof code);
    PROCESS_MITIGATION_EXTENSION_POINT_DISABLE_POLICY extensions{};
    extensions.DisableExtensionPoints = 1;
    SetProcessMitigationPolicy(ProcessExtensionPointDisablePolicy, &extensions, sizeof extensions);
    PROCESS_MITIGATION_IMAGE_LOAD_POLICY images{};
    images.NoRemoteImages = 1;
    images.NoLowMandatoryLabelImages = 1;
    SetProcessMitigationPolicy(ProcessImageLoadPolicy, &images, sizeof images);
}

void lowerOwnRights()
{
    core::ScopedHandle token;
    constexpr DWORD wanted = TOKEN_ADJUST_DEFAULT | TOKEN_ADJUST_PRIVILEGES | TOKEN_QUERY;
    if (OpenProcessToken(GetCurrentProcess(), wanted, token.out()))
        lowerRights(token.get());
}
} // namespace

void limitOwnProcess(std::uint64_t memory, std::uint64_t seconds)
{
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX); // no dialog, no dump
    enterJob(memory, seconds);
    forbidTricks();
    lowerOwnRights();
}
} // namespace app
