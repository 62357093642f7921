#pragma once

#include <string>
#include <string_view>

namespace app
{
/// Returns a COLLADA file in the form that Assimp reads correctly: UTF-8 even if the file is UTF-16, no blanks before
/// the first tag or before values, no empty references to images, and the true number of values at each float_array.
/// Assimp reads beyond the values if that number is wrong, and fails an assertion at an empty reference.
std::string colladaText(std::string_view bytes);
} // namespace app
