#include "ui/scene/ghost_shapes.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace ui
{
namespace
{
constexpr int around = 64, rings = 32;

/// A superellipsoid (Barr, 1981). Exponent 1 is round, near 0 it is a box.
struct Body
{
    core::Vec3 middle, half;
    double upright = 1, inPlan = 1; ///< exponents of the body's outline seen from the side, and from above
    int solidity = 255;
};

/// Opacity of skin and strap, 0 to 255. (The skull's centre is 9 cm behind the eyes, in z.)
constexpr int skinSolidity = 120, strapSolidity = 200;
const Body skull{.middle = {0, -0.01, 0.09}, .half = {0.074, 0.115, 0.098}, .solidity = skinSolidity};
const Body strap{.middle = {0, 0.012, 0.085}, .half = {0.082, 0.019, 0.110}, .upright = 0.3, .solidity = strapSolidity};
const Body visor{.middle = {0, 0, -0.035}, .half = {0.092, 0.052, 0.048}, .upright = 0.45, .inPlan = 0.5};

double power(double base, double exponent)
{
    return std::copysign(std::pow(std::abs(base), exponent), base);
}

/// Returns the vertex of a body at two angles in radians: `height` above the horizontal plane, `turn` about the
/// vertical.
core::DrawVertex vertex(const Body& body, double height, double turn)
{
    const double out = std::cos(height), up = std::sin(height), x = std::sin(turn), z = std::cos(turn);
    const auto surface = [&](double upright, double inPlan) {
        return core::Vec3(power(out, upright) * power(x, inPlan), power(up, upright),
                          power(out, upright) * power(z, inPlan));
    };
    const core::Vec3 point = body.middle + body.half.cwiseProduct(surface(body.upright, body.inPlan));
    const core::Vec3 normal = 127 * surface(2 - body.upright, 2 - body.inPlan).cwiseQuotient(body.half).normalized();
    const auto byte = [](double value) { return static_cast<std::int8_t>(std::lround(value)); };
    const auto solid = static_cast<std::uint8_t>(body.solidity);
    return {point.cast<float>(), {byte(normal.x()), byte(normal.y()), byte(normal.z()), 0}, {solid, solid, solid, 255}};
}

/// Appends a body's vertices as rings of latitude, from the lower pole to the upper, and its faces.
void add(core::DrawArrays& to, const Body& body)
{
    const auto first = static_cast<core::Slot>(to.vertices.size());
    for (int ring = 0; ring <= rings; ++ring)
        for (int i = 0; i < around; ++i)
            to.vertices.push_back(vertex(body, std::numbers::pi * (static_cast<double>(ring) / rings - 0.5),
                                         2 * std::numbers::pi * i / around));
    const auto at = [first](int ring, int i) { return first + static_cast<core::Slot>(ring * around + i % around); };
    for (int ring = 0; ring < rings; ++ring)
        for (int i = 0; i < around; ++i) {
            to.faces.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
            to.faces.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
        }
}
} // namespace

core::DrawArrays headShape()
{
    core::DrawArrays arrays;
    for (const Body& body : {skull, strap, visor})
        add(arrays, body);
    return arrays;
}

core::DrawArrays ballShape()
{
    core::DrawArrays arrays;
    add(arrays, {.middle = {0, 0, 0}, .half = {1, 1, 1}});
    return arrays;
}
} // namespace ui
