#pragma once

#include <string_view>

namespace core::io
{
/// Returns whether a glTF that requires the extension can be read. This is so if the extension is supported, or if it
/// only affects appearance (materials, textures, lights), metadata or animation, none of which is read.
bool isWithoutShape(std::string_view extension);
} // namespace core::io
