#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace simulator
{
/// 8 bits of red, green, blue and alpha a pixel, the top row first; sRGB.
struct Picture
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// As PNG. Throws std::runtime_error if it cannot be written.
void writePng(const Picture& picture, const std::string& path);
} // namespace simulator
