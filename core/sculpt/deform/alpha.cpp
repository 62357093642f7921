#include "core/sculpt/deform/alpha.h"

#include "core/util/fingerprint.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace core
{
Alpha::Alpha(int width, int height, std::vector<std::uint8_t> pixels, std::string source)
    : m_width(width)
    , m_height(height)
    , m_pixels(std::move(pixels))
    , m_source(std::move(source))
{
    assert(width > 0 && height > 0 && width <= maxSide && height <= maxSide);
    assert(m_pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

double Alpha::at(double right, double up) const
{
    const double half = 0.5 * std::max(m_width, m_height);
    const double fromMiddleX = right * half, fromMiddleY = -up * half;
    if (!(std::abs(fromMiddleX) <= 0.5 * m_width && std::abs(fromMiddleY) <= 0.5 * m_height))
        return 0;
    const double x = std::clamp(fromMiddleX + 0.5 * (m_width - 1), 0.0, m_width - 1.0);
    const double y = std::clamp(fromMiddleY + 0.5 * (m_height - 1), 0.0, m_height - 1.0);
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const auto pixel = [&](int i, int j) {
        const int column = std::min(i, m_width - 1), row = std::min(j, m_height - 1);
        return static_cast<double>(m_pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_width) +
                                            static_cast<std::size_t>(column)]);
    };
    const double s = x - left, t = y - top;
    const double upper = pixel(left, top) + s * (pixel(left + 1, top) - pixel(left, top));
    const double lower = pixel(left, top + 1) + s * (pixel(left + 1, top + 1) - pixel(left, top + 1));
    return (upper + t * (lower - upper)) / 255;
}

bool Alpha::isBuiltIn() const
{
    return std::ranges::count(builtInAlphas(), m_source) > 0;
}

std::string Alpha::fingerprint() const
{
    Fingerprint print;
    print.add(static_cast<std::uint32_t>(m_width));
    print.add(static_cast<std::uint32_t>(m_height));
    print.add(m_pixels);
    return print.text();
}
} // namespace core
