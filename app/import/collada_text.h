#pragma once

#include <string>
#include <string_view>

namespace app
{
/// Returns a COLLADA file as Assimp understands it: in UTF-8, whether it came as that or as UTF-16, without blanks
/// before it or before values; each float_array tells the number of its values. Assimp reads beyond the values where
/// one tells too few.
std::string colladaText(std::string_view bytes);
} // namespace app
