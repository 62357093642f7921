#pragma once

#include <cstddef>
#include <string_view>

namespace app
{
bool isBinaryFbx(std::string_view bytes);

/// Returns the version of a binary or text FBX file as the file writes it: 7400 is version 7.4. 0: no version found.
int fbxVersion(std::string_view bytes);

/// Returns the number of meshes to be subdivided for display. Assimp does not report it.
std::size_t fbxSubdivisions(std::string_view bytes);

/// Returns the number of NURBS surfaces. Assimp leaves them out.
std::size_t fbxNurbs(std::string_view bytes);
} // namespace app
