#include "core/io/mesh/input_file.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace core::io
{
InputFile::InputFile(const std::filesystem::path& path)
    : m_path(path)
    , m_descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
    if (m_descriptor < 0)
        throw FileError(FileErrorKind::NotReadable, m_path, errno);
}

InputFile::~InputFile()
{
    ::close(m_descriptor);
}

std::size_t InputFile::read(std::uint64_t offset, std::span<char> into) const
{
    std::size_t got = 0;
    while (got < into.size()) {
        const ssize_t part =
            ::pread(m_descriptor, into.data() + got, into.size() - got, static_cast<off_t>(offset + got));
        if (part < 0 && errno == EINTR)
            continue;
        if (part < 0)
            throw FileError(FileErrorKind::NotReadable, m_path, errno);
        if (part == 0)
            break;
        got += static_cast<std::size_t>(part);
    }
    return got;
}

} // namespace core::io
