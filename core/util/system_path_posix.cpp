#include "core/util/system_path.h"

#include "core/util/system_code.h"

namespace core
{
std::filesystem::path systemPath(const std::filesystem::path& path)
{
    return path;
}

FileStatus fileStatus(const std::filesystem::path& path)
{
    std::error_code problem;
    const std::filesystem::file_status found = std::filesystem::status(path, problem);
    FileStatus status{found.type(), 0, systemCodeOf(problem)};
    if (status.type == std::filesystem::file_type::regular) {
        status.size = std::filesystem::file_size(path, problem);
        if (problem)
            status = {std::filesystem::file_type::unknown, 0, systemCodeOf(problem)};
    }
    return status;
}
} // namespace core
