#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string_view>

namespace app
{
/// Returns the transform from Assimp's coordinates for a file that is not FBX to millimetres with Y up. Uses what the
/// format or the file states about unit and axes. `start`: first bytes of the file. Throws core::FileError for a unit
/// or an axis of OpenGEX that is none.
Eigen::Matrix4d placeOf(const std::filesystem::path& file, std::string_view start);

/// Returns whether files with this extension define a unit of length.
bool holdsUnit(const std::filesystem::path& file);
} // namespace app
