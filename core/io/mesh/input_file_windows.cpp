#include "core/io/mesh/input_file.h"

#include "core/util/system_file_windows.h"

#include <algorithm>

namespace core::io
{
/// Others may replace or delete the file meanwhile, as on other systems.
InputFile::InputFile(const std::filesystem::path& path)
    : m_path(path)
    , m_descriptor(openFile(path, {GENERIC_READ, shareAll, OPEN_EXISTING}))
{
    if (m_descriptor < 0)
        throw FileError(FileErrorKind::NotReadable, m_path, static_cast<int>(GetLastError()));
}

InputFile::~InputFile()
{
    closeFile(m_descriptor);
}

std::size_t InputFile::read(std::uint64_t offset, std::span<char> into) const
{
    constexpr std::size_t atOnce = std::size_t(1) << 26;
    std::size_t got = 0;
    while (got < into.size()) {
        OVERLAPPED place{};
        place.Offset = static_cast<DWORD>(offset + got);
        place.OffsetHigh = static_cast<DWORD>((offset + got) >> 32);
        DWORD part = 0;
        const auto wanted = static_cast<DWORD>(std::min(into.size() - got, atOnce));
        if (!ReadFile(handleOf(m_descriptor), into.data() + got, wanted, &part, &place)) {
            if (GetLastError() == ERROR_HANDLE_EOF)
                break;
            throw FileError(FileErrorKind::NotReadable, m_path, static_cast<int>(GetLastError()));
        }
        if (part == 0)
            break;
        got += part;
    }
    return got;
}
} // namespace core::io
