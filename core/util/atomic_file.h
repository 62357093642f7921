#pragma once

#include "core/util/file_error.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace core
{
/// Writes a file so that at each moment the path holds the whole old file or the whole new one, after a power cut too.
/// Until commit() nothing is seen under the path; without it nothing remains. Through a link the file it points to is
/// replaced, or made if it is not there; its permissions stay. Each member throws FileError.
class AtomicFile
{
public:
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Buffered.
    void write(std::string_view bytes);
    /// What was written so far is on disk, though nothing is seen of it.
    void sync();
    void commit();

    const std::filesystem::path& path() const { return m_path; } ///< as asked

private:
    void openTemporary();
    void flush();
    void writeNow(std::string_view bytes);
    void giveTemporaryName();
    [[noreturn]] void fail(int systemError) const;

    std::filesystem::path m_path;   ///< as asked, for errors
    std::filesystem::path m_target; ///< with links followed
    std::string m_temporary;        ///< empty while the file has no name
    std::string m_buffer;
    int m_descriptor = -1;
};

/// Gives a folder another name beside it, which outlives a power cut. False if something has that name already; else
/// throws FileError.
bool renameFolder(const std::filesystem::path& from, const std::filesystem::path& to);

/// A folder's names outlive a power cut, too. One that cannot be synced is no error.
void syncFolder(const std::filesystem::path& folder);

/// Of what the system says when writing fails.
FileErrorKind kindOfWriteError(int systemError);

/// Throws a FileError if there is a problem.
void checkWritten(const std::error_code& problem, const std::filesystem::path& path);
} // namespace core
