#pragma once

#include "core/util/slot.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>

/// Units and axes of the whole program: a document is in millimetres, right-handed, Y up. Triangles wind
/// counter-clockwise seen from outside; their normals point outside.
namespace core
{
using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;

/// Corner slots of a face, counter-clockwise from outside.
using Triangle = std::array<Slot, 3>;

/// Identifies a part of a document (core/parts).
using PartId = std::uint16_t;
inline constexpr PartId maxPartId = 0x7fff;

/// A colour in 8-bit sRGB.
struct Rgb
{
    std::uint8_t r = 200, g = 200, b = 200;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};
/// Interpolates between two colours; `share` is 0 to 1.
constexpr Rgb mixed(Rgb from, Rgb to, double share)
{
    const auto mix = [share](int a, int b) { return static_cast<std::uint8_t>(a + share * (b - a) + 0.5); };
    return {mix(from.r, to.r), mix(from.g, to.g), mix(from.b, to.b)};
}

struct Ray
{
    Vec3 origin = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ(); ///< any length but zero
};

struct Sphere
{
    Vec3 center = Vec3::Zero();
    double radius = 0;
};

/// Axis-aligned box; the default box is empty and grows with extend().
using Box = Eigen::AlignedBox3d;
} // namespace core
