#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core
{
/// A grey-scale image that weights a dab: white takes all of it, black nothing. Its longer side is the brush's
/// diameter, its middle the dab's centre. Immutable: any thread.
class Alpha
{
public:
    /// Of a side, in pixels: a reader refuses more before it decodes.
    static constexpr int maxSide = 4096;

    /// `pixels`: rows from the top, width x height of them. `source`: a name of builtInAlphas(), or the file's path.
    Alpha(int width, int height, std::vector<std::uint8_t> pixels, std::string source);

    /// Between pixel centres bilinear, 0 to 1. The image's longer side runs from -1 to 1; 0 beside it.
    double at(double right, double up) const;

    int width() const { return m_width; }
    int height() const { return m_height; }
    const std::vector<std::uint8_t>& pixels() const { return m_pixels; }
    const std::string& source() const { return m_source; }
    bool isBuiltIn() const;
    /// Of the image, in 16 hex digits.
    std::string fingerprint() const;

private:
    int m_width, m_height;
    std::vector<std::uint8_t> m_pixels;
    std::string m_source;
};

/// Our own, by their names in stroke files, in the order in which they are shown.
std::span<const std::string_view> builtInAlphas();
/// Drawn when it is first asked for. Null if there is none of that name.
std::shared_ptr<const Alpha> builtInAlpha(std::string_view name);
} // namespace core
