#pragma once

#include <string>

namespace core
{
/// Returns the version of OpenMesh that the program was built with.
std::string openMeshVersion();
} // namespace core
