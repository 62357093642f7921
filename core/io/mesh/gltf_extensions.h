#pragma once

#include <string_view>

namespace core::io
{
/// Whether a glTF that requires the extension can be read without knowing it, since it says only how the model looks
/// (materials, textures, lights), what is told of it, or what moves it: nothing of that is read. Extensions that we do
/// read are among them.
bool isWithoutShape(std::string_view extension);
} // namespace core::io
