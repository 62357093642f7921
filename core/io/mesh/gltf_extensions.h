#pragma once

#include <string_view>

namespace core::io
{
/// Returns whether a glTF that requires the extension can be read. It can if the extension is read, or if it says only
/// how the model looks (materials, textures, lights), what is told of it, or what moves it: nothing of that is read.
bool isWithoutShape(std::string_view extension);
} // namespace core::io
