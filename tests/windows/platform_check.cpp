// Tries what the files *_windows.cpp of core and app promise, on Windows or under Wine. It has no Qt, so that it
// can be built from Debian's packages alone.
//   platform_check FOLDER    tries everything in an empty folder; the exit status is the number of failures
// A check of something that Wine does not have is skipped, with the reason.
#include "app/platform/child_process.h"
#include "app/platform/process_signals.h"
#include "app/platform/process_usage.h"
#include "app/platform/resource_limits.h"
#include "core/io/large_buffer.h"
#include "core/io/mesh/input_file.h"
#include "core/io/numbered_backup.h"
#include "core/journal/append_file.h"
#include "core/journal/journal_folder.h"
#include "core/util/atomic_file.h"
#include "core/util/system_code.h"
#include "core/util/system_file_windows.h"
#include "core/util/thread_cpu_time.h"
#include "core/util/thread_priority.h"
#include "core/util/worker_pool.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>

namespace
{
namespace fs = std::filesystem;
using core::FileError;
using core::FileErrorKind;

int failures = 0;
bool isSkipped = false;

/// Says why a check, or a part of it, is not done here.
void skip(const char* reason)
{
    std::printf("SKIP  %s\n", reason);
    isSkipped = true;
}

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            std::printf("FAIL  line %d: %s\n", __LINE__, #condition);                                                  \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (false)

bool isWine()
{
    return GetProcAddress(GetModuleHandleW(L"ntdll.dll"), "wine_get_version") != nullptr;
}

std::string contentOf(const fs::path& file)
{
    std::ifstream stream(core::systemPath(file).c_str(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, std::string_view bytes)
{
    core::AtomicFile out(file);
    out.write(bytes);
    out.commit();
}

/// Returns the error that a function throws; nothing if it throws none.
std::optional<FileError> errorOf(const std::function<void()>& run)
{
    try {
        run();
    } catch (const FileError& error) {
        return error;
    }
    return std::nullopt;
}

bool fails(FileErrorKind kind, const std::function<void()>& run)
{
    const auto error = errorOf(run);
    return error && error->kind == kind;
}

std::size_t filesIn(const fs::path& folder)
{
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Runs this program as a child with these arguments.
app::ChildResult runSelf(std::vector<std::string> arguments, std::chrono::seconds time = std::chrono::seconds(20),
                         std::stop_token stop = {})
{
    arguments.insert(arguments.begin(), app::ownProgram());
    return app::runChild({std::move(arguments), time, 1 << 22, std::move(stop)});
}

/// A path that is longer than what Windows takes without a prefix.
fs::path deepFolder(const fs::path& folder)
{
    fs::path deep = folder;
    while (deep.native().size() < 300) {
        deep /= L"a folder with a long name";
        CreateDirectoryW(core::systemPath(deep).c_str(), nullptr);
    }
    return deep;
}

// --- core

void atomicFile_replacesOnlyAtCommit(const fs::path& folder)
{
    const fs::path file = folder / L"model.stl";
    write(file, "old");
    {
        core::AtomicFile out(file);
        out.write("new");
        out.sync();
        CHECK(contentOf(file) == "old");
    }
    CHECK(contentOf(file) == "old");
    CHECK(filesIn(folder) == 1); // nothing is left of what was not committed
    const std::string much(3 << 20, 'x');
    core::AtomicFile out(file);
    out.write("a");
    out.write(much);
    out.write("b");
    out.commit();
    CHECK(contentOf(file) == "a" + much + "b");
    CHECK(filesIn(folder) == 1);
}

/// Somebody who reads the file keeps the old content.
void atomicFile_replacesWhatIsBeingRead(const fs::path& folder)
{
    const fs::path file = folder / L"model.stl";
    write(file, "old content");
    const core::io::InputFile reader(file);
    if (isWine()) {
        skip("atomicFile_replacesWhatIsBeingRead: Wine 8 renames no file over one that is open");
        return;
    }
    const auto error = errorOf([&] { write(file, "new content"); });
    std::string seen(11, '\0');
    CHECK(reader.read(0, seen) == 11);
    CHECK(seen == "old content");
    CHECK(!error && contentOf(file) == "new content");
}

void atomicFile_refuses(const fs::path& folder)
{
    CHECK(fails(FileErrorKind::NotAFile, [&] { core::AtomicFile out(folder); }));
    CHECK(fails(FileErrorKind::NoFolder, [&] { core::AtomicFile out(folder / L"none" / L"a.stl"); }));
    CHECK(fails(FileErrorKind::NotAFile, [&] { core::AtomicFile out(folder / L"NUL"); }));
    const fs::path file = folder / L"locked.stl";
    write(file, "mine");
    if (isWine()) {
        skip("atomicFile_refuses, in part: under Wine, root may write to files that are read-only");
    } else {
        SetFileAttributesW(file.c_str(), FILE_ATTRIBUTE_READONLY);
        CHECK(fails(FileErrorKind::NotWritable, [&] { core::AtomicFile out(file); }));
        SetFileAttributesW(file.c_str(), FILE_ATTRIBUTE_NORMAL);
    }
    {
        const core::ScopedHandle other(
            CreateFileW(file.c_str(), GENERIC_READ, 0, nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr));
        const auto error = errorOf([&] { core::AtomicFile out(file); });
        CHECK(error && error->kind == FileErrorKind::NotWritable && error->systemError == ERROR_SHARING_VIOLATION);
    }
    CHECK(contentOf(file) == "mine");
    CHECK(filesIn(folder) == 1);
}

void atomicFile_keepsAttributes(const fs::path& folder)
{
    const fs::path file = folder / L"hidden.stl";
    write(file, "old");
    SetFileAttributesW(file.c_str(), FILE_ATTRIBUTE_HIDDEN);
    write(file, "new");
    CHECK(contentOf(file) == "new");
    CHECK(GetFileAttributesW(file.c_str()) & FILE_ATTRIBUTE_HIDDEN);
}

/// A program that is killed leaves no file behind.
void atomicFile_isGoneWithItsProgram(const fs::path& folder)
{
    const auto result = runSelf({"die-writing", (folder / L"model.stl").string()});
    CHECK(result.bytes == "written\n");
    CHECK(filesIn(folder) == 0);
}

void links_areFollowed(const fs::path& folder)
{
    const fs::path file = folder / L"target.stl", link = folder / L"link.stl", dangling = folder / L"dangling.stl";
    write(file, "old");
    constexpr DWORD flags = 0x2; // SYMBOLIC_LINK_FLAG_ALLOW_UNPRIVILEGED_CREATE
    CreateSymbolicLinkW(link.c_str(), L"target.stl", flags);
    if (GetFileAttributesW(link.c_str()) == INVALID_FILE_ATTRIBUTES) {
        skip("links_areFollowed: no symbolic link can be made here");
        return;
    }
    CreateSymbolicLinkW(dangling.c_str(), (folder / L"later.stl").c_str(), flags);
    write(link, "new");
    CHECK(contentOf(file) == "new");
    write(dangling, "made");
    CHECK(contentOf(folder / L"later.stl") == "made");
    CHECK(GetFileAttributesW(link.c_str()) & FILE_ATTRIBUTE_REPARSE_POINT);
}

void names_mayBeOfAnyScriptAndLength(const fs::path& folder)
{
    const fs::path chinese = folder / L"\u6a21\u578b \u82b1\u74f6.stl";
    write(chinese, "vase");
    CHECK(contentOf(chinese) == "vase");
    std::string seen(4, '\0');
    CHECK(core::io::InputFile(chinese).read(0, seen) == 4 && seen == "vase");
    CHECK(chinese.filename().string() == "\xe6\xa8\xa1\xe5\x9e\x8b \xe8\x8a\xb1\xe7\x93\xb6.stl"); // UTF-8
    CHECK(core::pathOfUtf8(chinese.filename().string()) == chinese.filename());
    const fs::path deep = deepFolder(folder) / L"model.stl";
    CHECK(deep.native().size() > MAX_PATH);
    write(deep, "deep");
    write(deep, "deeper");
    CHECK(contentOf(deep) == "deeper");
    std::string long_(6, '\0');
    CHECK(core::io::InputFile(deep).read(0, long_) == 6 && long_ == "deeper");
    core::AppendFile(deep.parent_path() / L"log").append("x");
    CHECK(contentOf(deep.parent_path() / L"log") == "x");
    CHECK(core::FolderLock(deep.parent_path()).isHeld());
}

void renameFolder_saysWhatIsTaken(const fs::path& folder)
{
    const fs::path from = folder / L"from", to = folder / L"to", other = folder / L"other";
    fs::create_directory(from);
    fs::create_directory(other);
    CHECK(!core::renameFolder(from, other));
    CHECK(core::renameFolder(from, to));
    CHECK(fs::is_directory(to) && !fs::exists(from));
    CHECK(fails(FileErrorKind::NoFolder, [&] { core::renameFolder(from, folder / L"again"); }));
}

/// Virus scanners open what has just been written, and no folder is renamed meanwhile.
void renameFolder_waitsForOthers(const fs::path& folder)
{
    const fs::path from = folder / L"from", to = folder / L"to", file = from / L"model.stl";
    fs::create_directory(from);
    write(file, "scanned");
    auto reader = std::make_unique<core::io::InputFile>(file);
    {
        const std::jthread closing([&reader] {
            Sleep(200);
            reader.reset();
        });
        CHECK(core::renameFolder(from, to));
    }
    CHECK(contentOf(to / L"model.stl") == "scanned" && !fs::exists(from));
}

void appendFile_appends(const fs::path& folder)
{
    const fs::path file = folder / L"segment-0";
    {
        core::AppendFile log(file);
        std::thread syncing([&log] {
            for (int i = 0; i < 20; ++i)
                log.sync();
        });
        for (int i = 0; i < 1000; ++i)
            log.append("0123456789");
        syncing.join();
        CHECK(contentOf(file).size() == 10000); // others see it at once
        CHECK(errorOf([&] { core::AppendFile again(file); }).has_value());
    }
    core::syncFile(file);
    CHECK(fails(FileErrorKind::NoFolder, [&] { core::syncFile(folder / L"none"); }));
    const auto taken = errorOf([&] { core::AppendFile again(file); });
    CHECK(taken && core::isSystemCode(taken->systemError, std::errc::file_exists));
}

void folderLock_isExclusive(const fs::path& folder)
{
    const fs::path journal = folder / L".journal", shown = folder / L"journal";
    CHECK(fails(FileErrorKind::NoFolder, [&] { core::FolderLock lock(journal); }));
    fs::create_directory(journal);
    auto lock = std::make_unique<core::FolderLock>(journal);
    CHECK(lock->isHeld());
    CHECK(!core::FolderLock(journal).isHeld());
    fs::rename(journal, shown); // a folder that is locked can be renamed, and stays locked
    CHECK(!core::FolderLock(shown).isHeld());
    CHECK(runSelf({"lock", shown.string()}).bytes == "taken\n");
    lock.reset();
    CHECK(runSelf({"lock", shown.string()}).bytes == "held\n"); // and is killed while it holds the lock
    CHECK(core::FolderLock(shown).isHeld());
}

void journalFolder_isFoundWhenAbandoned(const fs::path& folder)
{
    auto journal = core::JournalFolder::makeHidden(folder);
    CHECK(core::JournalFolder::abandoned(folder).empty());
    journal->show();
    CHECK(core::JournalFolder::abandoned(folder).empty());
    const fs::path path = journal->path();
    journal.reset();
    auto found = core::JournalFolder::abandoned(folder);
    CHECK(found.size() == 1 && found.front()->path() == path);
    found.front()->remove();
    found.clear();
    CHECK(filesIn(folder) == 0);
}

void inputFile_readsAnyPart(const fs::path& folder)
{
    const fs::path file = folder / L"numbers";
    std::string bytes(100000, '\0');
    std::iota(bytes.begin(), bytes.end(), '\0');
    write(file, bytes);
    const core::io::InputFile input(file);
    std::vector<std::thread> readers;
    std::vector<int> good(4);
    for (std::size_t i = 0; i < good.size(); ++i)
        readers.emplace_back([&, i] {
            std::string part(25000, '\0');
            good[i] = input.read(25000 * i, part) == part.size() && part == bytes.substr(25000 * i, 25000);
        });
    for (std::thread& reader : readers)
        reader.join();
    CHECK(good == std::vector<int>(4, 1));
    std::string end(100, '\0');
    CHECK(input.read(99990, end) == 10);
    CHECK(input.read(200000, end) == 0);
    const auto missing = errorOf([&] { core::io::InputFile none(folder / L"none"); });
    CHECK(missing && core::isSystemCode(missing->systemError, std::errc::no_such_file_or_directory));
}

void numberedBackup_keepsVersions(const fs::path& folder)
{
    const fs::path file = folder / L"vase.glb";
    for (const char* const content : {"1", "2", "3", "4"}) {
        core::NumberedBackup backup(file, 2);
        write(file, content);
        backup.commit();
    }
    CHECK(contentOf(file) == "4");
    CHECK(contentOf(core::NumberedBackup::nameOf(file, 1)) == "3");
    CHECK(contentOf(core::NumberedBackup::nameOf(file, 2)) == "2");
    CHECK(filesIn(folder) == 3);
    const fs::path chinese = folder / (std::wstring(80, L'\u82b1') + L".glb");
    for (const char* const content : {"1", "2"}) {
        core::NumberedBackup backup(chinese, 2);
        write(chinese, content);
        backup.commit();
    }
    CHECK(contentOf(core::NumberedBackup::nameOf(chinese, 1)) == "1");
}

void fileStatus_tellsWhatIsThere(const fs::path& folder)
{
    const fs::path file = folder / L"\u7b14\u753b.json";
    CHECK(core::fileStatus(file).type == fs::file_type::not_found);
    CHECK(core::fileStatus(folder / L"none" / L"none").type == fs::file_type::not_found);
    write(file, "four");
    CHECK(core::fileStatus(file).type == fs::file_type::regular && core::fileStatus(file).size == 4);
    CHECK(core::fileStatus(folder).type == fs::file_type::directory);
    CHECK(core::fileStatus(L"NUL").type == fs::file_type::character);
    const fs::path deep = deepFolder(folder) / L"model.stl";
    write(deep, "deep");
    CHECK(core::fileStatus(deep).size == 4);
}

void systemCode_isOfTheSystem(const fs::path& folder)
{
    std::error_code problem;
    CHECK(fs::file_size(folder / L"none", problem) == std::uintmax_t(-1));
    CHECK(core::isSystemCode(core::systemCodeOf(problem), std::errc::no_such_file_or_directory));
    fs::create_directory(folder / L"none" / L"other", problem);
    CHECK(core::isSystemCode(core::systemCodeOf(problem), std::errc::no_such_file_or_directory));
    CHECK(core::systemCodeOf(std::make_error_code(std::errc::file_exists)) == ERROR_FILE_EXISTS);
    CHECK(core::systemCodeOf({}) == 0);
    core::clearStreamCode();
    const std::ifstream missing((folder / L"none").c_str());
    CHECK(core::isSystemCode(core::streamCode(), std::errc::no_such_file_or_directory));
}

void largeBuffer_isUsable(const fs::path&)
{
    for (const std::size_t size : {std::size_t(0), std::size_t(1000), std::size_t(3) << 20, std::size_t(64) << 20}) {
        core::LargeBuffer<char> buffer(size);
        if (size > 0)
            std::memset(buffer.data(), 7, size);
        CHECK(buffer.size() == size && (size == 0 || (buffer[0] == 7 && buffer[size - 1] == 7)));
    }
    bool isRefused = false;
    try {
        core::allocateLarge(std::size_t(1) << 60);
    } catch (const std::bad_alloc&) {
        isRefused = true;
    }
    CHECK(isRefused);
}

void threadPriority_isLowered(const fs::path&)
{
    std::thread([] {
        core::lowerThreadPriority(core::ThreadPriority::Batch);
        CHECK(GetThreadPriority(GetCurrentThread()) == THREAD_PRIORITY_NORMAL);
        core::lowerThreadPriority(core::ThreadPriority::Idle);
        CHECK(GetThreadPriority(GetCurrentThread()) < THREAD_PRIORITY_BELOW_NORMAL);
    }).join();
    CHECK(GetThreadPriority(GetCurrentThread()) == THREAD_PRIORITY_NORMAL);
}

// --- app

void usage_grows(const fs::path&)
{
    const double before = core::threadCpuMs();
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    while (std::chrono::steady_clock::now() < end) {
    }
    CHECK(core::threadCpuMs() > before);
    CHECK(app::peakRssMb() > 1 && app::peakRssMb() < 4096);
}

void busyFor(std::chrono::microseconds time)
{
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end) {
    }
}

/// The caller sleeps if a helper works for 300 microseconds longer than it. A helper that ends just then wakes it.
void workers_areWoken(const fs::path&)
{
    core::WorkerPool pool;
    const auto caller = std::this_thread::get_id();
    std::atomic<unsigned> calls{0};
    constexpr unsigned runs = 10000;
    for (unsigned i = 0; i < runs; ++i)
        pool.run(
            [&] {
                ++calls;
                busyFor(std::chrono::microseconds(std::this_thread::get_id() == caller ? 30 : 280 + i % 100));
            },
            1);
    CHECK(calls >= runs && calls <= 2 * runs);
}

void child_getsItsArguments(const fs::path&)
{
    const std::vector<std::string> odd{
        "a b", "", "\"q\"", R"(back\slash)", R"(end\)", R"(\"both\\")", "\xe8\x8a\xb1\xe7\x93\xb6"};
    std::vector<std::string> arguments{"echo"};
    std::string expected;
    for (const std::string& word : odd) {
        arguments.push_back(word);
        expected += word + '\n';
    }
    const auto result = runSelf(arguments);
    CHECK(result.end == app::ChildResult::End::Exited);
    CHECK(result.bytes == expected);
}

void child_isEnded(const fs::path&)
{
    using End = app::ChildResult::End;
    CHECK(runSelf({"sleep"}, std::chrono::seconds(1)).end == End::TooSlow);
    std::stop_source stop;
    std::thread stopping([&stop] {
        Sleep(300);
        stop.request_stop();
    });
    CHECK(runSelf({"sleep"}, std::chrono::seconds(20), stop.get_token()).end == End::Stopped);
    stopping.join();
    CHECK(runSelf({"flood"}).end == End::Died);
    CHECK(runSelf({"status", "3"}).end == End::Died);
    CHECK(runSelf({"status", "1816"}).end == End::TooSlow);
    CHECK(app::runChild({{"C:\\none.exe"}, std::chrono::seconds(1), 1}).end == End::NotStarted);
}

void child_givesMuch(const fs::path&)
{
    const auto result = runSelf({"much"});
    CHECK(result.end == app::ChildResult::End::Exited);
    CHECK(result.bytes.size() == (4 << 20) && result.bytes.back() == 'z');
}

/// A process that has limited itself works on, and cannot do what it may not.
void limits_hold(const fs::path& folder)
{
    write(folder / L"read.me", "readable");
    const auto result = runSelf({"limited", folder.string()});
    CHECK(result.end == app::ChildResult::End::Exited);
    std::printf("      limited process: %s", result.bytes.c_str());
    CHECK(result.bytes.starts_with("reads "));
    if (isWine()) {
        skip("limits_hold, in part: Wine 8 keeps no limits of jobs and no integrity of tokens");
        return;
    }
    CHECK(result.bytes == "reads no-memory no-program no-writing\n");
    CHECK(runSelf({"busy"}, std::chrono::seconds(20)).end == app::ChildResult::End::TooSlow);
}

// --- what this program does as a child

std::string limitedAbilities(const fs::path& folder)
{
    app::limitOwnProcess(std::uint64_t(64) << 20, 10);
    std::string able = contentOf(folder / L"read.me") == "readable" ? "reads" : "reads-nothing";
    void* const memory = VirtualAlloc(nullptr, std::size_t(256) << 20, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
    able += memory ? " memory" : " no-memory";
    const auto child = runSelf({"status", "0"});
    able += child.end == app::ChildResult::End::Exited ? " program" : " no-program";
    able += errorOf([&] { write(folder / L"written", "x"); }) ? " no-writing" : " writing";
    return able + "\n";
}

int runAsChild(const std::string& word, const std::vector<fs::path>& rest)
{
    if (word == "echo") {
        for (const fs::path& argument : rest)
            std::printf("%s\n", argument.string().c_str());
    } else if (word == "sleep") {
        Sleep(60000);
    } else if (word == "flood") {
        const std::string piece(1 << 16, 'x');
        while (std::fwrite(piece.data(), 1, piece.size(), stdout) == piece.size()) {
        }
    } else if (word == "much") {
        std::string much(4 << 20, 'x');
        much.back() = 'z';
        std::fwrite(much.data(), 1, much.size(), stdout);
    } else if (word == "status") {
        ExitProcess(static_cast<UINT>(std::stoi(rest.at(0).string())));
    } else if (word == "busy") {
        app::limitOwnProcess(std::uint64_t(64) << 20, 1);
        for (std::atomic<int> i = 0;; ++i) {
        }
    } else if (word == "limited") {
        std::printf("%s", limitedAbilities(rest.at(0)).c_str());
    } else if (word == "lock") {
        const core::FolderLock lock(rest.at(0));
        std::printf("%s\n", lock.isHeld() ? "held" : "taken");
        std::fflush(stdout);
        TerminateProcess(GetCurrentProcess(), 0);
    } else if (word == "die-writing") {
        core::AtomicFile out(rest.at(0));
        out.write("half of a model");
        out.sync();
        std::printf("written\n");
        std::fflush(stdout);
        TerminateProcess(GetCurrentProcess(), 0);
    }
    return 0;
}

std::vector<fs::path> wideArguments()
{
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    return {words + 1, words + count};
}

struct Check
{
    const char* name;
    void (*run)(const fs::path&);
};

#define NAMED(function)                                                                                                \
    {                                                                                                                  \
#function, function                                                                                            \
    }
constexpr Check checks[] = {
    NAMED(atomicFile_replacesOnlyAtCommit),
    NAMED(atomicFile_replacesWhatIsBeingRead),
    NAMED(atomicFile_refuses),
    NAMED(atomicFile_keepsAttributes),
    NAMED(atomicFile_isGoneWithItsProgram),
    NAMED(links_areFollowed),
    NAMED(names_mayBeOfAnyScriptAndLength),
    NAMED(renameFolder_saysWhatIsTaken),
    NAMED(renameFolder_waitsForOthers),
    NAMED(appendFile_appends),
    NAMED(folderLock_isExclusive),
    NAMED(journalFolder_isFoundWhenAbandoned),
    NAMED(inputFile_readsAnyPart),
    NAMED(numberedBackup_keepsVersions),
    NAMED(fileStatus_tellsWhatIsThere),
    NAMED(systemCode_isOfTheSystem),
    NAMED(largeBuffer_isUsable),
    NAMED(threadPriority_isLowered),
    NAMED(usage_grows),
    NAMED(workers_areWoken),
    NAMED(child_getsItsArguments),
    NAMED(child_isEnded),
    NAMED(child_givesMuch),
    NAMED(limits_hold),
};
} // namespace

int main(int argc, char* argv[])
{
    _setmode(_fileno(stdout), _O_BINARY);
    const std::vector<fs::path> arguments = wideArguments();
    if (argc < 2)
        return 2;
    if (argc > 2 || std::strcmp(argv[1], "sleep") == 0 || std::strcmp(argv[1], "flood") == 0 ||
        std::strcmp(argv[1], "much") == 0 || std::strcmp(argv[1], "busy") == 0)
        return runAsChild(argv[1], {arguments.begin() + 1, arguments.end()});
    app::surviveFileSizeLimit();
    app::surviveBrokenPipes();
    app::endOnInterrupt();
    for (const Check& check : checks) {
        const fs::path folder = arguments[0] / check.name;
        fs::create_directories(folder);
        const int before = failures;
        isSkipped = false;
        try {
            check.run(folder);
        } catch (const std::exception& error) {
            std::printf("FAIL  %s\n", error.what());
            ++failures;
        }
        if (failures != before || !isSkipped)
            std::printf("%s  %s\n", failures == before ? "PASS" : "FAIL", check.name);
        std::fflush(stdout);
    }
    return failures;
}
