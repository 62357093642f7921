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
/// A grey-scale image that scales the effect of a dab: full effect where it is white, none where it is black. Its
/// longer side spans the brush's diameter, and its middle is the dab's centre. Immutable. Thread: any.
class Alpha
{
public:
    /// Largest width and height, in pixels. Readers refuse larger images before decoding them.
    static constexpr int maxSide = 4096;

    /// Makes an alpha. `pixels`: width x height values, row by row from the top. `source`: a name in builtInAlphas(),
    /// or the file's path.
    Alpha(int width, int height, std::vector<std::uint8_t> pixels, std::string source);

    /// Returns the shade at a point, 0 to 1, interpolated bilinearly between pixel centres. The image's longer side
    /// extends from -1 to 1; outside the image the shade is 0.
    double at(double right, double up) const;

    int width() const { return m_width; }
    int height() const { return m_height; }
    const std::vector<std::uint8_t>& pixels() const { return m_pixels; }
    const std::string& source() const { return m_source; }
    bool isBuiltIn() const;
    /// Returns a fingerprint of the image: 16 hexadecimal digits.
    std::string fingerprint() const;

private:
    int m_width, m_height;
    std::vector<std::uint8_t> m_pixels;
    std::string m_source;
};

/// Returns the names of the built-in alphas, as used in stroke files, in display order.
std::span<const std::string_view> builtInAlphas();
/// Returns the built-in alpha of this name, or null. All are drawn at the first call.
std::shared_ptr<const Alpha> builtInAlpha(std::string_view name);
} // namespace core
