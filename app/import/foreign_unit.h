#pragma once

#include <filesystem>

namespace app
{
/// Returns the millimetres in one unit of Assimp's coordinates, by the format of a file that is not FBX; 1 if the
/// format has no unit.
double unitOf(const std::filesystem::path& file);

/// Returns whether files with this extension define a unit of length.
bool holdsUnit(const std::filesystem::path& file);
} // namespace app
