#include "app/platform/resource_limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#ifdef __linux__
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

namespace app
{
namespace
{
void limit(__rlimit_resource resource, std::uint64_t max)
{
    const rlimit value{max, max};
    setrlimit(resource, &value);
}

/// Returns the address space in use, bytes; 0 if the system does not report it.
std::uint64_t usedNow()
{
    unsigned long pages = 0;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lu", &pages) != 1)
            pages = 0;
        std::fclose(file);
    }
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void limitMemory(std::uint64_t memory)
{
#if !defined(__SANITIZE_ADDRESS__) &&                                                                                  \
    !defined(__SANITIZE_THREAD__) // sanitizers reserve more address space than the machine has
    const auto machine =
        static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    limit(RLIMIT_AS, usedNow() + std::min(memory, machine));
#endif
}

#ifdef __linux__
/// Identifier of this machine's system call table for seccomp; 0: not supported, so no call is forbidden.
#if defined(__x86_64__)
constexpr std::uint32_t ownCalls = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t ownCalls = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t ownCalls = 0;
#endif

/// Makes the listed system calls fail with EPERM from now on.
void forbidCalls()
{
    constexpr std::uint32_t forbidden[] = {SYS_socket,   SYS_socketpair, SYS_connect,   SYS_execve,   SYS_execveat,
                                           SYS_unlinkat, SYS_renameat,   SYS_renameat2, SYS_truncate, SYS_ptrace,
                                           SYS_kill,     SYS_tgkill,
#ifdef SYS_unlink // newer architectures do not have these calls
                                           SYS_unlink,   SYS_rename,     SYS_fork,      SYS_vfork
#endif
    };
    constexpr auto count = std::size(forbidden);
    constexpr auto rule = [](int code, std::uint32_t value, std::size_t ifSo = 0) {
        return sock_filter{static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(ifSo), 0, value};
    };
    constexpr int load = BPF_LD | BPF_W | BPF_ABS, isEqual = BPF_JMP | BPF_JEQ | BPF_K, end = BPF_RET | BPF_K;
    sock_filter rules[4 + count + 2] = {rule(load, offsetof(seccomp_data, arch)), rule(isEqual, ownCalls, 1),
                                        rule(end, SECCOMP_RET_KILL), rule(load, offsetof(seccomp_data, nr))};
    for (std::size_t i = 0; i < count; ++i)
        rules[4 + i] = rule(isEqual, forbidden[i], count - i);
    rules[4 + count] = rule(end, SECCOMP_RET_ALLOW);
    rules[5 + count] = rule(end, SECCOMP_RET_ERRNO | EPERM);
    const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
    if (ownCalls != 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}
#endif
} // namespace

void limitOwnProcess(std::uint64_t memory, std::uint64_t seconds)
{
    limitMemory(memory);
    limit(RLIMIT_CPU, seconds);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CORE, 0);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close_range(STDERR_FILENO + 1, ~0U, 0);
    forbidCalls();
#endif
}
} // namespace app
