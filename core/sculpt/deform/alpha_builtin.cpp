// The built-in alphas, drawn by formulas: each gives a shade for every point of the square from -1 to 1, x to the right
// and y up.
#include "core/sculpt/deform/alpha.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core
{
namespace
{
constexpr int pixelsPerSide = 256;

/// Returns 0 for x up to `from`, 1 beyond `to`, and a smooth transition between them.
double smoothStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double distanceOf(double x, double y)
{
    return std::sqrt(x * x + y * y);
}

/// Returns a pseudo-random number in [0, 1) for a cell of a grid. `which`: selects an independent set of numbers.
double cellValue(double column, double row, std::uint32_t which)
{
    std::uint32_t h = static_cast<std::uint32_t>(static_cast<int>(column)) * 0x8da6b343u ^
                      static_cast<std::uint32_t>(static_cast<int>(row)) * 0xd8163841u ^ which * 0xcb1ab31fu;
    for (int i = 0; i < 2; ++i)
        h = (h ^ h >> 15) * 0x2c1b3c6du;
    return (h ^ h >> 16) * 0x1p-32;
}

/// Returns a semicircular profile: height 1 at x = 0, falling to 0 at |x| = 1.
double dome(double x)
{
    return std::sqrt(std::max(1 - x * x, 0.0));
}

/// Randomly placed points, one in each cell of a grid. `jitter`: their largest offset from the middle of the cell, in
/// half cells.
struct Seeds
{
    double cells; ///< number of cells per side of the square, whose side is 2
    double jitter;

    template <class Visit> void forEachNear(double x, double y, Visit visit) const
    {
        const double column = std::floor(0.5 * cells * (x + 1)), row = std::floor(0.5 * cells * (y + 1));
        for (double i = column - 2; i <= column + 2; ++i) {
            for (double j = row - 2; j <= row + 2; ++j) {
                const double dx = 0.5 + jitter * (cellValue(i, j, 1) - 0.5),
                             dy = 0.5 + jitter * (cellValue(i, j, 2) - 0.5);
                visit((i + dx) / (0.5 * cells) - 1, (j + dy) / (0.5 * cells) - 1, cellValue(i, j, 3));
            }
        }
    }
};

double shadeOfPores(double x, double y)
{
    double shade = 0;
    Seeds{8, 0.7}.forEachNear(x, y, [&](double sx, double sy, double size) {
        shade = std::max(shade, dome(distanceOf(x - sx, y - sy) / (0.06 + 0.05 * size)));
    });
    return shade;
}

/// Draws scales in rows. The raised free edges of each row cover the roots of the row below.
double shadeOfScales(double x, double y)
{
    constexpr double rows = 0.26, columns = 0.4, radius = 0.27;
    const double lowest = std::floor((y + 1) / rows);
    for (double row = lowest + 4; row >= lowest - 1; --row) {
        const double shift = static_cast<int>(row) % 2 == 0 ? 0 : 0.5 * columns;
        const double cx = columns * std::round((x - shift) / columns) + shift, cy = rows * row - 1;
        const double d = distanceOf(x - cx, y - cy) / radius;
        if (d < 1)
            return std::clamp(0.6 + 0.55 * (cy - y) / radius, 0.1, 1.0) * (1 - smoothStep(0.86, 1, d));
    }
    return 0;
}

/// Draws lines where two seeds are equally near (edges of Voronoi cells).
double shadeOfCracks(double x, double y)
{
    double first = 9, second = 9, fx = 0, fy = 0, sx = 0, sy = 0;
    Seeds{5, 0.95}.forEachNear(x, y, [&](double px, double py, double) {
        const double d = distanceOf(x - px, y - py);
        if (d < first) {
            second = first, sx = fx, sy = fy;
            first = d, fx = px, fy = py;
        } else if (d < second) {
            second = d, sx = px, sy = py;
        }
    });
    const double between = distanceOf(sx - fx, sy - fy);
    const double fromEdge = (second - first) * (second + first) / (2 * between);
    return 1 - smoothStep(0.015, 0.075, fromEdge);
}

/// Draws bands that pass alternately over and under each other.
double shadeOfWeave(double x, double y)
{
    constexpr double cell = 0.4, width = 0.46; // width: half the width of a band, in cells
    const double column = std::floor((x + 1) / cell), row = std::floor((y + 1) / cell);
    const double s = (x + 1) / cell - column - 0.5, t = (y + 1) / cell - row - 0.5;
    const bool isLevel = static_cast<int>(column + row + 64) % 2 == 0;
    const double along = isLevel ? s : t, across = isLevel ? t : s;
    const double over = std::abs(across) < width ? dome(across / width) * (0.55 + 0.45 * dome(2 * along)) : 0;
    const double under = std::abs(along) < width ? 0.5 * dome(along / width) : 0;
    return std::max(over, under);
}

/// Draws a star with five points, and a ridge along each.
double shadeOfStar(double x, double y)
{
    constexpr double inner = 0.4;
    constexpr std::array<std::array<double, 2>, 5> rays{{{0, 1},
                                                         {0.951056516295154, 0.309016994374947},
                                                         {0.587785252292473, -0.809016994374947},
                                                         {-0.587785252292473, -0.809016994374947},
                                                         {-0.951056516295154, 0.309016994374947}}};
    constexpr double outer = 0.95;
    double shade = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto& tip = rays[i];
        const auto& opposite = rays[(i + 3) % 5]; // the notch between this tip and the next is opposite to this ray
        const double ax = outer * tip[0], ay = outer * tip[1], bx = -inner * opposite[0], by = -inner * opposite[1];
        const auto& next = rays[(i + 1) % 5];
        const double cx = outer * next[0], cy = outer * next[1];
        // the triangle of the middle, a tip and a notch
        const auto halfOf = [&](double px, double py, double qx, double qy) {
            const double area = px * qy - py * qx;
            const double u = (x * qy - y * qx) / area, v = (px * y - py * x) / area;
            if (u >= 0 && v >= 0 && u + v <= 1)
                shade = std::max(shade, 1 - u - v);
        };
        halfOf(ax, ay, bx, by);
        halfOf(bx, by, cx, cy);
    }
    return shade > 0 ? std::min(0.35 + 1.3 * shade, 1.0) : 0;
}

double shadeOfRing(double x, double y)
{
    return dome((distanceOf(x, y) - 0.66) / 0.2);
}

/// Draws noise: four octaves of smoothly interpolated random values.
double shadeOfNoise(double x, double y)
{
    double sum = 0, share = 0.5, cells = 5;
    for (std::uint32_t octave = 0; octave < 4; ++octave, share *= 0.5, cells *= 2) {
        const double px = cells * (0.5 * x + 0.5), py = cells * (0.5 * y + 0.5), column = std::floor(px),
                     row = std::floor(py);
        const double s = smoothStep(0, 1, px - column), t = smoothStep(0, 1, py - row);
        const auto value = [&](double i, double j) { return cellValue(column + i, row + j, 10 + octave); };
        const double lower = value(0, 0) + s * (value(1, 0) - value(0, 0)),
                     upper = value(0, 1) + s * (value(1, 1) - value(0, 1));
        sum += share * (lower + t * (upper - lower));
    }
    return smoothStep(0.2, 0.75, sum);
}

double shadeOfStripes(double x, double)
{
    constexpr double period = 0.4;
    const double t = x / period + 0.5;
    return dome((t - std::floor(t) - 0.5) / 0.32);
}

struct DrawnAlpha
{
    std::string_view name;
    double (*shade)(double x, double y);
};
constexpr std::array<DrawnAlpha, 8> alphaTable{{{"pores", shadeOfPores},
                                                {"scales", shadeOfScales},
                                                {"cracks", shadeOfCracks},
                                                {"weave", shadeOfWeave},
                                                {"stripes", shadeOfStripes},
                                                {"noise", shadeOfNoise},
                                                {"ring", shadeOfRing},
                                                {"star", shadeOfStar}}};

/// Returns the image of an alpha. Each pixel is the mean of 2 x 2 samples.
std::shared_ptr<const Alpha> drawn(const DrawnAlpha& builtIn)
{
    std::vector<std::uint8_t> pixels;
    pixels.reserve(std::size_t(pixelsPerSide) * pixelsPerSide);
    for (int row = 0; row < pixelsPerSide; ++row) {
        for (int column = 0; column < pixelsPerSide; ++column) {
            double sum = 0;
            for (const double dy : {0.25, 0.75})
                for (const double dx : {0.25, 0.75})
                    sum += builtIn.shade((column + dx) / (0.5 * pixelsPerSide) - 1,
                                         1 - (row + dy) / (0.5 * pixelsPerSide));
            pixels.push_back(static_cast<std::uint8_t>(255 * std::clamp(sum / 4, 0.0, 1.0) + 0.5));
        }
    }
    return std::make_shared<Alpha>(pixelsPerSide, pixelsPerSide, std::move(pixels), std::string(builtIn.name));
}
} // namespace

std::span<const std::string_view> builtInAlphas()
{
    static constexpr auto names = [] {
        std::array<std::string_view, alphaTable.size()> result;
        std::ranges::transform(alphaTable, result.begin(), &DrawnAlpha::name);
        return result;
    }();
    return names;
}

std::shared_ptr<const Alpha> builtInAlpha(std::string_view name)
{
    static const std::vector<std::shared_ptr<const Alpha>> all = [] {
        std::vector<std::shared_ptr<const Alpha>> alphas;
        std::ranges::transform(alphaTable, std::back_inserter(alphas), drawn);
        return alphas;
    }();
    const auto found =
        std::ranges::find(all, name, [](const auto& alpha) { return std::string_view(alpha->source()); });
    return found == all.end() ? nullptr : *found;
}
} // namespace core
