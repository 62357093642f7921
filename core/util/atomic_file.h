#pragma once

#include "core/util/file_error.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace core
{
/// Replaces a file atomically: even after a power cut, the path has either the whole old content or the whole new one.
/// The new content is invisible until commit(); destruction without commit() discards it. A symbolic link is followed:
/// its target is replaced, or created if missing. Permissions of an existing file are kept. The constructor, write(),
/// sync() and commit() throw FileError.
class AtomicFile
{
public:
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Appends bytes to a buffer of 1 MiB, which is written to the file when full.
    void write(std::string_view bytes);
    /// Forces everything written so far to disk. The target path still shows the old content.
    void sync();
    void commit();

    /// Returns the path as passed to the constructor, with links not followed.
    const std::filesystem::path& path() const { return m_path; }

private:
    static constexpr std::size_t bufferSize = 1 << 20;

    void openTemporary();
    /// Returns a name beside the target that is unique to this call. The caller creates the file exclusively.
    /// `process`: number of this process, unique among those that run.
    std::filesystem::path temporaryName(unsigned long process) const;
    void flush();
    void writeNow(std::string_view bytes);
    void giveTemporaryName();
    [[noreturn]] void fail(int systemError) const;

    std::filesystem::path m_path;      ///< path as passed to the constructor, for errors
    std::filesystem::path m_target;    ///< m_path with symbolic links followed
    std::filesystem::path m_temporary; ///< path of the temporary file; empty while it has none (O_TMPFILE)
    std::string m_buffer;
    int m_descriptor = -1;
};

/// Renames a folder within its parent folder, durably: the new name survives a power cut. Returns false if the new name
/// is taken. Throws FileError on any other failure.
bool renameFolder(const std::filesystem::path& from, const std::filesystem::path& to);

/// Syncs a folder, so that renames and new files in it survive a power cut. Failure is ignored.
void syncFolder(const std::filesystem::path& folder);

/// Maps the system code of a failed write to an error kind (system_code.h).
FileErrorKind kindOfWriteError(int systemError);

/// Throws a FileError if `problem` is set.
void checkWritten(const std::error_code& problem, const std::filesystem::path& path);
} // namespace core
