#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string_view>

namespace app
{
/// Returns the transform from what Assimp gives of a file that is not FBX to millimetres with Y up, as far as the
/// format or the file itself says what they are. `start`: the file's first bytes.
Eigen::Matrix4d placeOf(const std::filesystem::path& file, std::string_view start);

/// Returns whether files with that ending are measured in a unit of their own.
bool holdsUnit(const std::filesystem::path& file);
} // namespace app
