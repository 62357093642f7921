// Sources: Microsoft Learn, "CreateProcessW function", "UpdateProcThreadAttribute function", "Nested Jobs",
// "Parsing C++ command-line arguments", "CancelIoEx function".
#include "app/platform/child_process.h"

#include "app/platform/low_rights_windows.h"

#include "core/util/system_file_windows.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>
#include <windows.h>

namespace app
{
namespace
{
using Clock = std::chrono::steady_clock;
using End = ChildResult::End;
using core::ScopedHandle;

constexpr DWORD pollEveryMs = 20;
constexpr std::size_t pieceSize = 1 << 16; ///< largest part of the output that is read at a time, bytes
constexpr UINT killed = 1816; ///< ERROR_NOT_ENOUGH_QUOTA, as the system ends a process that exceeds a limit of its job

std::wstring utf16(std::string_view text)
{
    const auto size = static_cast<int>(text.size());
    std::wstring wide(static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)), '\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), size, wide.data(), static_cast<int>(wide.size()));
    return wide;
}

std::string utf8(std::wstring_view text)
{
    const auto size = static_cast<int>(text.size());
    std::string narrow(
        static_cast<std::size_t>(WideCharToMultiByte(CP_UTF8, 0, text.data(), size, nullptr, 0, nullptr, nullptr)),
        '\0');
    WideCharToMultiByte(CP_UTF8, 0, text.data(), size, narrow.data(), static_cast<int>(narrow.size()), nullptr,
                        nullptr);
    return narrow;
}

/// Appends a word so that the program which is started finds it again among its arguments. Backslashes are doubled
/// where a quotation mark follows.
void appendQuoted(std::wstring& line, const std::wstring& word)
{
    constexpr wchar_t quote = 0x22, backslash = 0x5c;
    if (!line.empty())
        line += L" ";
    line += quote;
    std::size_t backslashes = 0;
    for (const wchar_t c : word) {
        if (c == quote)
            line.append(backslashes + 1, backslash);
        backslashes = c == backslash ? backslashes + 1 : 0;
        line += c;
    }
    line.append(backslashes, backslash);
    line += quote;
}

/// A pipe whose reading end does not block, which only named pipes have.
struct OutputPipe
{
    OutputPipe()
    {
        static std::atomic<unsigned> counter{0};
        const std::wstring name =
            LR"(\\.\pipe\fettle-)" + std::to_wstring(GetCurrentProcessId()) + L"-" + std::to_wstring(counter++);
        constexpr DWORD bytes = 1 << 20;
        reading.reset(CreateNamedPipeW(
            name.c_str(), PIPE_ACCESS_INBOUND | FILE_FLAG_OVERLAPPED | FILE_FLAG_FIRST_PIPE_INSTANCE,
            PIPE_TYPE_BYTE | PIPE_READMODE_BYTE | PIPE_WAIT | PIPE_REJECT_REMOTE_CLIENTS, 1, bytes, bytes, 0, nullptr));
        if (!reading)
            return;
        SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
        writing.reset(CreateFileW(name.c_str(), GENERIC_WRITE, 0, &inherited, OPEN_EXISTING, 0, nullptr));
    }

    ScopedHandle reading, writing;
};

/// The list of what a child gets beyond its command line: the handles that it inherits, and no others.
class StartAttributes
{
public:
    StartAttributes(HANDLE* handles, std::size_t count)
    {
        SIZE_T size = 0;
        InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
        m_memory.resize(size);
        m_isReady = InitializeProcThreadAttributeList(list(), 1, 0, &size) != 0;
        m_isGood = m_isReady && UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles,
                                                          count * sizeof(HANDLE), nullptr, nullptr);
    }
    ~StartAttributes()
    {
        if (m_isReady)
            DeleteProcThreadAttributeList(list());
    }
    StartAttributes(const StartAttributes&) = delete;
    StartAttributes& operator=(const StartAttributes&) = delete;

    bool isGood() const { return m_isGood; }
    LPPROC_THREAD_ATTRIBUTE_LIST list() { return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(m_memory.data()); }

private:
    std::vector<std::byte> m_memory;
    bool m_isReady = false, m_isGood = false;
};

/// Returns a copy of this process's token with few rights. Without one the child lowers its own (resource_limits.h).
void makeLowToken(ScopedHandle& low)
{
    ScopedHandle own;
    constexpr DWORD wanted =
        TOKEN_DUPLICATE | TOKEN_ASSIGN_PRIMARY | TOKEN_QUERY | TOKEN_ADJUST_DEFAULT | TOKEN_ADJUST_PRIVILEGES;
    if (!OpenProcessToken(GetCurrentProcess(), wanted, own.out()) ||
        !CreateRestrictedToken(own.get(), DISABLE_MAX_PRIVILEGE, 0, nullptr, 0, nullptr, 0, nullptr, low.out()) ||
        !lowerRights(low.get()))
        low.reset();
}

/// Puts the process into a new job, which ends all its processes when its last handle is closed. That happens even if
/// this program crashes. Returns whether it is in the job. The job has no limits of the user's desktop: the process
/// could then enter none of its own (limitOwnProcess()), because jobs with such limits cannot be nested.
bool enterJob(ScopedHandle& job, HANDLE process)
{
    job.reset(CreateJobObjectW(nullptr, nullptr));
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    return job && SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits) &&
           AssignProcessToJobObject(job.get(), process);
}

/// A child and its job. Both end with this object.
struct Child
{
    ScopedHandle job, process;
};

/// Starts the program, suspended until it is in its job. Returns whether it runs.
bool start(const std::vector<std::string>& command, HANDLE output, Child& child)
{
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    const ScopedHandle nothing(CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                           &inherited, OPEN_EXISTING, 0, nullptr));
    std::array<HANDLE, 2> handles{nothing.get(), output};
    StartAttributes attributes(handles.data(), handles.size());
    if (!nothing || !attributes.isGood())
        return false;
    const std::wstring program = utf16(command.front());
    std::wstring line;
    for (const std::string& word : command)
        appendQuoted(line, utf16(word));
    STARTUPINFOEXW info{};
    info.StartupInfo.cb = sizeof info;
    info.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    info.StartupInfo.hStdInput = info.StartupInfo.hStdError = nothing.get();
    info.StartupInfo.hStdOutput = output;
    info.lpAttributeList = attributes.list();
    constexpr DWORD flags = CREATE_SUSPENDED | CREATE_NO_WINDOW | EXTENDED_STARTUPINFO_PRESENT;
    ScopedHandle token;
    makeLowToken(token);
    PROCESS_INFORMATION started{};
    const bool isLow = token && CreateProcessAsUserW(token.get(), program.c_str(), line.data(), nullptr, nullptr, TRUE,
                                                     flags, nullptr, nullptr, &info.StartupInfo, &started);
    if (!isLow && !CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, flags, nullptr, nullptr,
                                  &info.StartupInfo, &started))
        return false;
    child.process.reset(started.hProcess);
    const ScopedHandle thread(started.hThread);
    if (!enterJob(child.job, child.process.get())) {
        TerminateProcess(child.process.get(), killed);
        return false;
    }
    ResumeThread(thread.get());
    return true;
}

/// Reads from the pipe without blocking for longer than pollEveryMs at a time.
class PipeReader
{
public:
    explicit PipeReader(HANDLE pipe) : m_pipe(pipe), m_event(CreateEventW(nullptr, TRUE, FALSE, nullptr))
    {
        m_state.hEvent = m_event.get();
    }
    /// The system writes into the buffer until the read has ended. If it cannot be cancelled, it is just ending.
    ~PipeReader()
    {
        DWORD ignored = 0;
        if (m_isPending && (CancelIoEx(m_pipe, &m_state) || GetLastError() == ERROR_NOT_FOUND))
            GetOverlappedResult(m_pipe, &m_state, &ignored, TRUE);
    }
    PipeReader(const PipeReader&) = delete;
    PipeReader& operator=(const PipeReader&) = delete;

    /// Returns the bytes that have arrived, none if there are none yet. `problem` becomes the reason why nothing more
    /// can be read: ERROR_BROKEN_PIPE at the end.
    std::string_view read(DWORD& problem)
    {
        DWORD got = 0;
        if (!m_isPending && !ReadFile(m_pipe, m_piece.data(), static_cast<DWORD>(m_piece.size()), nullptr, &m_state) &&
            GetLastError() != ERROR_IO_PENDING) {
            problem = GetLastError();
            return {};
        }
        m_isPending = true;
        if (WaitForSingleObject(m_event.get(), pollEveryMs) != WAIT_OBJECT_0)
            return {};
        m_isPending = false;
        if (!GetOverlappedResult(m_pipe, &m_state, &got, FALSE))
            problem = GetLastError();
        return {m_piece.data(), got};
    }

private:
    HANDLE m_pipe;
    ScopedHandle m_event;
    OVERLAPPED m_state{};
    std::array<char, pieceSize> m_piece;
    bool m_isPending = false;
};

/// Reads the output of a process until it closes it or ends (Exited), or until a limit is exceeded or a read fails. The
/// pipe of an ended process stays open if another program, started meanwhile, has inherited it.
End collect(HANDLE input, HANDLE process, const ChildRequest& request, Clock::time_point deadline, std::string& bytes)
{
    PipeReader reader(input);
    for (;;) {
        if (request.stop.stop_requested())
            return End::Stopped;
        if (Clock::now() > deadline)
            return End::TooSlow;
        const bool hasEnded = WaitForSingleObject(process, 0) == WAIT_OBJECT_0;
        DWORD problem = 0;
        const std::string_view piece = reader.read(problem);
        if (problem != 0)
            return problem == ERROR_BROKEN_PIPE ? End::Exited : End::Died;
        if (hasEnded && piece.empty())
            return End::Exited;
        if (bytes.size() + piece.size() > request.maxBytes)
            return End::Died;
        bytes += piece;
    }
}

/// Waits for the child and returns its exit status. A child that has closed its output gets one second to end; any
/// other child is killed at once, with what it started.
DWORD statusOf(const Child& child, bool isEnding)
{
    if (WaitForSingleObject(child.process.get(), isEnding ? 1000 : 0) != WAIT_OBJECT_0) {
        TerminateJobObject(child.job.get(), killed);
        WaitForSingleObject(child.process.get(), INFINITE);
    }
    DWORD status = killed;
    GetExitCodeProcess(child.process.get(), &status);
    return status;
}
} // namespace

std::string ownProgram()
{
    std::wstring path(MAX_PATH, '\0');
    for (;;) {
        const DWORD size = GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size()));
        if (size < path.size())
            return utf8(std::wstring_view(path).substr(0, size));
        path.resize(2 * path.size());
    }
}

ChildResult runChild(const ChildRequest& request)
{
    OutputPipe pipe;
    if (!pipe.writing)
        return {End::NotStarted, {}};
    ChildResult result{End::NotStarted, {}};
    Child child;
    const bool isStarted = start(request.command, pipe.writing.get(), child);
    pipe.writing.reset(); // the child has its own, whose end ends the reading
    if (!isStarted)
        return result;
    result.end = collect(pipe.reading.get(), child.process.get(), request, Clock::now() + request.time, result.bytes);
    const DWORD status = statusOf(child, result.end == End::Exited);
    constexpr DWORD quotaExceeded = 0xC0000044; // STATUS_QUOTA_EXCEEDED
    if (result.end == End::Exited && status != 0)
        result.end = status == killed || status == quotaExceeded ? End::TooSlow : End::Died;
    return result;
}
} // namespace app
