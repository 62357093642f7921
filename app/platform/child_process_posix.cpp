#include "app/platform/child_process.h"

#include <QCoreApplication>

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <optional>

namespace app
{
namespace
{
using Clock = std::chrono::steady_clock;
using End = ChildResult::End;

constexpr int pollEveryMs = 20;

/// Starts the program. `output`: the writing end of a pipe, which becomes the child's standard output.
std::optional<pid_t> start(const std::vector<std::string>& command, int output)
{
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    // A child inherits ignored signals. It needs the default SIGPIPE, to end when nobody reads its output any more.
    sigset_t byDefault;
    sigemptyset(&byDefault);
    sigaddset(&byDefault, SIGPIPE);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &byDefault);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int problem = posix_spawn(&child, arguments.front(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return problem == 0 ? std::optional(child) : std::nullopt;
}

/// Reads the child's output until the child closes it (Exited), or until a limit is exceeded or a read fails.
End collect(int input, const ChildRequest& request, Clock::time_point deadline, std::string& bytes)
{
    std::array<char, 1 << 16> piece;
    for (;;) {
        if (request.stop.stop_requested())
            return End::Stopped;
        if (Clock::now() > deadline)
            return End::TooSlow;
        pollfd what{input, POLLIN, 0};
        if (poll(&what, 1, pollEveryMs) <= 0)
            continue;
        const ssize_t got = read(input, piece.data(), piece.size());
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return got == 0 ? End::Exited : End::Died;
        if (bytes.size() + static_cast<std::size_t>(got) > request.maxBytes)
            return End::Died;
        bytes.append(piece.data(), static_cast<std::size_t>(got));
    }
}

/// Waits for the child and returns its exit status. A child that has closed its output gets one second to end; any
/// other child is killed at once.
int statusOf(pid_t child, bool isEnding)
{
    int status = 0;
    const auto deadline = Clock::now() + std::chrono::seconds(isEnding ? 1 : 0);
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (Clock::now() >= deadline)
            kill(child, SIGKILL);
        poll(nullptr, 0, 1);
    }
    return status;
}
} // namespace

std::string ownProgram()
{
#ifdef __linux__
    return "/proc/self/exe";
#else
    return QCoreApplication::applicationFilePath().toStdString();
#endif
}

ChildResult runChild(const ChildRequest& request)
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        return {End::NotStarted, {}};
    const auto child = start(request.command, ends[1]);
    close(ends[1]);
    ChildResult result{End::NotStarted, {}};
    if (child) {
        result.end = collect(ends[0], request, Clock::now() + request.time, result.bytes);
        const int status = statusOf(*child, result.end == End::Exited);
        const bool byLimit = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
        if (result.end == End::Exited && !(WIFEXITED(status) && WEXITSTATUS(status) == 0))
            result.end = byLimit ? End::TooSlow : End::Died;
    }
    close(ends[0]);
    return result;
}
} // namespace app
