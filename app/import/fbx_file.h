#pragma once

#include <cstddef>
#include <string_view>

namespace app
{
bool isBinaryFbx(std::string_view bytes);

/// Returns the version of an FBX file, binary or text, as it stands there: 7400 is 7.4. 0: there is none.
int fbxVersion(std::string_view bytes);

/// Returns how many of its meshes are to be subdivided, which Assimp does not tell.
std::size_t fbxSubdivisions(std::string_view bytes);

/// Returns how many surfaces of it are NURBS, which Assimp leaves out.
std::size_t fbxNurbs(std::string_view bytes);
} // namespace app
