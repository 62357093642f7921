// The body is lofted over the sections of a table. The pad is cut into four sides and a middle. The buttons are plates
// and ellipsoids that protrude a little from the body.
#include "vr/scene/wand_model.h"

#include "vr/openxr/wand_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vr
{
namespace
{
using std::numbers::pi;

/// Cross-section of the body at one z; metres.
struct Section
{
    double z, halfWidth, top, bottom;
};

constexpr Section sections[] = {
    {0.1010, 0.0060, 0.0050, -0.0075},  {0.0990, 0.0110, 0.0088, -0.0120},  {0.0940, 0.0142, 0.0112, -0.0148},
    {0.0800, 0.0158, 0.0130, -0.0162},  {0.0400, 0.0160, 0.0138, -0.0168},  {0.0000, 0.0172, 0.0146, -0.0172},
    {-0.0250, 0.0208, 0.0152, -0.0176}, {-0.0450, 0.0238, 0.0155, -0.0174}, {-0.0650, 0.0232, 0.0153, -0.0164},
    {-0.0800, 0.0196, 0.0142, -0.0142}, {-0.0950, 0.0146, 0.0114, -0.0112}, {-0.1120, 0.0098, 0.0078, -0.0080},
    {-0.1260, 0.0066, 0.0052, -0.0054}, {-0.1310, 0.0050, 0.0040, -0.0042},
};
constexpr int stepsBetween = 4, sidesAround = 56;
constexpr double squareness = 2.5; ///< exponent of a section's superellipse; 2 is an ellipse

constexpr double padMiddleZ = -0.048, padRadius = 0.0190, padMiddleRadius = 0.0062, padGap = 0.0007;
constexpr double padBottom = 0.0130, padTop = 0.0166;
constexpr double menuZ = -0.0830, menuRadius = 0.0046;
/// Cross-section of the thumbstick at a height y, metres. The table below is in order from the hollow in the cap to the
/// foot in the body.
struct StickSection
{
    double height, radius;
};
constexpr StickSection stickSections[] = {{0.0238, 0.0030}, {0.0246, 0.0070}, {0.0246, 0.0086},
                                          {0.0236, 0.0094}, {0.0220, 0.0094}, {0.0208, 0.0082},
                                          {0.0195, 0.0044}, {0.0160, 0.0046}, {0.0120, 0.0058}};
constexpr double stickWay = 22 * pi / 180;
constexpr double sideZ = 0.0120;
const core::Vec3 triggerMiddle(0, -0.0205, -0.0440), triggerHinge(0, -0.0120, -0.0640);
constexpr double triggerWay = 16 * pi / 180;

double between(double a, double b, double c, double d, double t)
{
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a))); // Catmull-Rom spline
}

/// Returns the section between section i and the next one at t, 0 to 1.
Section sectionAt(std::size_t i, double t)
{
    const auto at = [&](int offset) -> const Section& {
        return sections[std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(i) + offset, 0,
                                                   std::ssize(sections) - 1)];
    };
    const auto value = [&](double Section::*of) { return between(at(-1).*of, at(0).*of, at(1).*of, at(2).*of, t); };
    return {value(&Section::z), value(&Section::halfWidth), value(&Section::top), value(&Section::bottom)};
}

SolidBuilder::Loop loopOf(const Section& section)
{
    const auto power = [](double x) { return std::copysign(std::pow(std::abs(x), 2 / squareness), x); };
    SolidBuilder::Loop loop;
    for (int i = 0; i < sidesAround; ++i) {
        const double turn = 2 * pi * i / sidesAround, up = power(std::sin(turn));
        loop.emplace_back(section.halfWidth * power(std::cos(turn)), up > 0 ? up * section.top : -up * section.bottom,
                          section.z);
    }
    return loop;
}

SolidBuilder body()
{
    std::vector<SolidBuilder::Loop> loops;
    for (std::size_t i = 0; i + 1 < std::size(sections); ++i)
        for (int step = 0; step < stepsBetween; ++step)
            loops.push_back(loopOf(sectionAt(i, static_cast<double>(step) / stepsBetween)));
    loops.push_back(loopOf(sections[std::size(sections) - 1]));
    SolidBuilder solid;
    solid.loft(loops);
    return solid;
}

/// Returns a point at a radius from the pad's middle, metres. A turn of 0 points to the tip; turns are in radians,
/// counter-clockwise as seen from above.
core::Vec3 onPad(double radius, double turn)
{
    return {-radius * std::sin(turn), 0, padMiddleZ - radius * std::cos(turn)};
}

/// Returns a quarter of the pad without its middle, with a gap on each side.
SolidBuilder padSide(double turn)
{
    constexpr int steps = 14;
    const auto arc = [&](double radius, int step) {
        const double half = pi / 4 - padGap / radius;
        return onPad(radius, turn + half * (2.0 * step / steps - 1));
    };
    SolidBuilder::Loop outline;
    for (int step = 0; step <= steps; ++step)
        outline.push_back(arc(padRadius, step));
    for (int step = steps; step >= 0; --step)
        outline.push_back(arc(padMiddleRadius + 2 * padGap, step));
    return plate(outline, {padBottom, padTop, 0.0005});
}

SolidBuilder::Loop circle(const core::Vec3& middle, double radius)
{
    constexpr int steps = 32;
    SolidBuilder::Loop outline;
    for (int i = 0; i < steps; ++i)
        outline.push_back(middle + radius * core::Vec3(std::sin(2 * pi * i / steps), 0, std::cos(2 * pi * i / steps)));
    return outline;
}

SolidBuilder stick()
{
    std::vector<SolidBuilder::Loop> loops;
    for (const auto& [height, radius] : stickSections)
        loops.push_back(circle({0, height, padMiddleZ}, radius));
    SolidBuilder solid;
    solid.loft(loops);
    return solid;
}

SolidBuilder sideButtons()
{
    SolidBuilder both = ellipsoid({0.0158, -0.0010, sideZ}, {0.0030, 0.0046, 0.0135});
    both.add(ellipsoid({-0.0158, -0.0010, sideZ}, {0.0030, 0.0046, 0.0135}));
    return both;
}
} // namespace

core::DrawArrays wandPartModel(WandPart part)
{
    switch (part) {
    case WandPart::Body:
        return body().drawArrays();
    case WandPart::PadUp:
        return padSide(0).drawArrays();
    case WandPart::PadLeft:
        return padSide(pi / 2).drawArrays();
    case WandPart::PadDown:
        return padSide(pi).drawArrays();
    case WandPart::PadRight:
        return padSide(-pi / 2).drawArrays();
    case WandPart::PadMiddle:
        return plate(circle({0, 0, padMiddleZ}, padMiddleRadius), {padBottom, padTop - 0.0003, 0.0004}).drawArrays();
    case WandPart::Stick:
        return stick().drawArrays();
    case WandPart::Menu:
        return plate(circle({0, 0, menuZ}, menuRadius), {0.0100, 0.0149, 0.0006}).drawArrays();
    case WandPart::Trigger:
        return ellipsoid(triggerMiddle, {0.0066, 0.0096, 0.0180}).drawArrays();
    case WandPart::Side:
        return sideButtons().drawArrays();
    case WandPart::Tip:
        return ellipsoid(wandTip(), core::Vec3::Constant(wandTipRadius)).drawArrays();
    }
    return {};
}

core::Vec3 placeOf(WandSpot spot)
{
    switch (spot) {
    case WandSpot::PadUp:
        return placeOnPad({0, 0.7});
    case WandSpot::PadLeft:
        return placeOnPad({-0.7, 0});
    case WandSpot::PadDown:
        return placeOnPad({0, -0.7});
    case WandSpot::PadRight:
        return placeOnPad({0.7, 0});
    case WandSpot::PadMiddle:
        return placeOnPad({0, 0});
    case WandSpot::Menu:
        return {0, 0.0150, menuZ};
    case WandSpot::Trigger:
        return triggerMiddle - core::Vec3(0.0066, 0, 0);
    case WandSpot::Side:
        return {0.0186, -0.0010, sideZ};
    }
    return core::Vec3::Zero();
}

core::Vec3 wandTip()
{
    return {0, 0, -tipReach};
}

core::Vec3 placeOnPad(const Eigen::Vector2d& touch)
{
    return {padRadius * touch.x(), padTop, padMiddleZ - padRadius * touch.y()};
}

Eigen::Affine3d stickTurn(const Eigen::Vector2d& push)
{
    const core::Vec3 foot(0, std::rbegin(stickSections)->height, padMiddleZ);
    const double share = std::min(1.0, push.norm());
    // Normalized() leaves a zero vector unchanged.
    const core::Vec3 axis = core::Vec3(-push.y(), 0, -push.x()).normalized();
    return Eigen::Translation3d(foot) * Eigen::AngleAxisd(stickWay * share, share > 0 ? axis : core::Vec3::UnitX()) *
           Eigen::Translation3d(-foot);
}

Eigen::Affine3d triggerTurn(double pull)
{
    return Eigen::Translation3d(triggerHinge) *
           Eigen::AngleAxisd(-triggerWay * std::clamp(pull, 0.0, 1.0), core::Vec3::UnitX()) *
           Eigen::Translation3d(-triggerHinge);
}
} // namespace vr
