#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace simulator
{
/// An sRGB picture of 8 bits each of red, green, blue and alpha per pixel, the top row first.
struct Picture
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Writes the picture as a PNG file. Throws std::runtime_error if that is impossible.
void writePng(const Picture& picture, const std::string& path);
} // namespace simulator
