#include "core/util/atomic_file.h"

#include "core/util/system_code.h"

#include <atomic>

namespace core
{
void checkWritten(const std::error_code& problem, const std::filesystem::path& path)
{
    if (!problem)
        return;
    const int systemError = systemCodeOf(problem);
    throw FileError(kindOfWriteError(systemError), path, systemError);
}

std::filesystem::path AtomicFile::temporaryName(unsigned long process) const
{
    static std::atomic<unsigned> counter{0};
    const std::string name = ".fettle-" + std::to_string(process) + "-" + std::to_string(counter++) + ".tmp";
    return m_target.parent_path() / name;
}

void AtomicFile::write(std::string_view bytes)
{
    if (m_buffer.size() + bytes.size() > bufferSize)
        flush();
    if (bytes.size() > bufferSize)
        writeNow(bytes);
    else
        m_buffer.append(bytes);
}

void AtomicFile::flush()
{
    writeNow(m_buffer);
    m_buffer.clear();
}

void AtomicFile::fail(int systemError) const
{
    const FileErrorKind kind = kindOfWriteError(systemError);
    throw FileError(kind, kind == FileErrorKind::NoFolder ? m_target : m_path, systemError);
}
} // namespace core
