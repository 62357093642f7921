#include "core/journal/journal_files.h"

#include <charconv>
#include <fstream>

namespace core
{
namespace
{
constexpr std::string_view basePrefix = "base-", segmentPrefix = "segment-";

/// Returns the number after the prefix; nothing if the file has another kind of name.
std::optional<unsigned> numberOf(std::string_view name, std::string_view prefix)
{
    unsigned number = 0;
    if (!name.starts_with(prefix))
        return std::nullopt;
    name.remove_prefix(prefix.size());
    const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
    return problem == std::errc() && end == name.data() + name.size() ? std::optional(number) : std::nullopt;
}
} // namespace

std::filesystem::path startFile(const std::filesystem::path& folder)
{
    return folder / "start";
}

std::filesystem::path baseFile(const std::filesystem::path& folder, unsigned segment)
{
    return folder / (std::string(basePrefix) + std::to_string(segment));
}

std::filesystem::path segmentFile(const std::filesystem::path& folder, unsigned segment)
{
    return folder / (std::string(segmentPrefix) + std::to_string(segment));
}

JournalFiles filesIn(const std::filesystem::path& folder)
{
    JournalFiles files;
    std::error_code problem;
    for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
        const std::string name = entry.path().filename().string();
        const std::uintmax_t size = entry.file_size(problem);
        if (const auto base = numberOf(name, basePrefix))
            files.bases[*base] = problem ? 0 : size;
        else if (const auto segment = numberOf(name, segmentPrefix))
            files.segments[*segment] = problem ? 0 : size;
    }
    return files;
}

std::string contentOf(const std::filesystem::path& file)
{
    std::error_code problem;
    const std::uintmax_t size = std::filesystem::file_size(file, problem);
    std::string bytes(problem ? 0 : static_cast<std::size_t>(size), '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}
} // namespace core
