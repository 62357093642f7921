#pragma once

#include "core/geometry/geometry.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace core
{
/// The effect of a dab on the vertices it selects. Pull, Push, Flatten, Smooth and Paint are the paper's (sections 3.3,
/// 3.5.3); deform.cpp explains the fields of the others.
enum class Tool {
    Pull,
    Push,
    Inflate,
    Clay,
    Layer,
    Flatten,
    Scrape,
    Smooth,
    Pinch,
    Crease,
    Grab,
    SnakeHook,
    Twist,
    Stamp,
    Paint,
    Mask
};

/// Drag tools use the motion from sample to sample; the first dab of a stroke moves nothing.
constexpr bool isDragTool(Tool tool)
{
    return tool == Tool::Grab || tool == Tool::SnakeHook || tool == Tool::Twist;
}
/// Keeps the selection of its first dab for the whole stroke; other tools select with each dab.
constexpr bool keepsSelection(Tool tool)
{
    return tool == Tool::Grab || tool == Tool::Twist;
}
/// Moves nothing and remeshes nothing: colours the surface, or masks it.
constexpr bool paintsAttribute(Tool tool)
{
    return tool == Tool::Paint || tool == Tool::Mask;
}
/// Weights what is under the brush by an alpha, too. A kept selection moves away from under the image, and Stamp has a
/// shape of its own.
constexpr bool usesAlpha(Tool tool)
{
    return !keepsSelection(tool) && tool != Tool::Stamp;
}
/// Makes edges sharp, on a mesh that is finer for it.
constexpr bool sharpens(Tool tool)
{
    return tool == Tool::Pinch || tool == Tool::Crease;
}
/// Can be one dab that the hand drags out (StrokeSettings::anchored): has an alpha or a model to show.
constexpr bool canAnchor(Tool tool)
{
    return tool == Tool::Stamp || (usesAlpha(tool) && !isDragTool(tool));
}
/// Goes on where the hand rests, if StrokeSettings::airbrush says so.
constexpr bool canAirbrush(Tool tool)
{
    return tool == Tool::Pull || tool == Tool::Push || tool == Tool::Inflate || tool == Tool::Clay ||
           tool == Tool::Smooth || tool == Tool::Pinch || tool == Tool::Paint;
}
/// Returns the part of the radius, 0 to 1, within which the tool moves everything alike; b(x) falls off from there to
/// the rim. What Snake Hook has there keeps its shape and stays with the brush. With a falloff from the centre on, all
/// but the tip would fall behind, and what is drawn out become a thread.
constexpr double coreShare(Tool tool)
{
    return tool == Tool::SnakeHook ? 0.5 : 0;
}
/// Adds a ball, or the brush's model, where StrokeSettings::add wants it.
constexpr bool canAddSolid(Tool tool)
{
    return tool == Tool::Pull || tool == Tool::Stamp;
}
/// Whether StrokeSettings::inverted changes what it does.
constexpr bool hasInverse(Tool tool)
{
    return tool == Tool::Inflate || tool == Tool::Clay || tool == Tool::Layer || tool == Tool::Scrape ||
           tool == Tool::Pinch || tool == Tool::Crease || tool == Tool::Twist || tool == Tool::Stamp ||
           tool == Tool::Mask;
}

/// How a dab selects vertices (paper, section 3.1).
enum class BrushShape {
    Sphere, ///< within the radius of the centre, by Euclidean distance
    Ray     ///< within the radius of the point that a ray hits, by geodesic distance along the surface
};

/// How fine the mesh under the brush becomes.
enum class Topology {
    Refine,   ///< as fine as the brush; what is finer already stays so
    Adaptive, ///< as fine as the brush, neither finer nor coarser (paper, section 3.2.2)
    Keep,     ///< as it is, except where a motion would not be valid without remeshing
    Uniform   ///< of one edge length, the same for the whole model
};
/// Leaves detail that is finer than the brush as it is.
constexpr bool keepsDetail(Topology topology)
{
    return topology == Topology::Refine || topology == Topology::Keep;
}

/// The source of a dab's centre.
enum class Placement {
    Point,   ///< the sample's position, as with a wand
    Nearest, ///< the surface point nearest to it
    Ray      ///< the first hit of position + direction, as with a mouse; no hit: the dab is empty
};

/// The plane through the origin about which a stroke is mirrored (paper, section 3.5.2): x, y or z = 0.
enum class Symmetry { None, X, Y, Z };

/// The names of an enumeration's values in files, in their order.
template <class Value> inline constexpr std::array<std::string_view, 0> valueNames{};
template <>
inline constexpr std::array<std::string_view, 16> valueNames<Tool>{
    "pull",  "push",   "inflate", "clay",  "layer", "flatten", "scrape", "smooth",
    "pinch", "crease", "grab",    "snake", "twist", "stamp",   "paint",  "mask"};
template <> inline constexpr std::array<std::string_view, 2> valueNames<BrushShape>{"sphere", "ray"};
template <>
inline constexpr std::array<std::string_view, 4> valueNames<Topology>{"refine", "adaptive", "keep", "uniform"};
template <> inline constexpr std::array<std::string_view, 3> valueNames<Placement>{"point", "nearest", "ray"};
template <> inline constexpr std::array<std::string_view, 4> valueNames<Symmetry>{"none", "x", "y", "z"};

/// Returns the names of the tools in the order of the palette.
constexpr std::span<const std::string_view> toolNames()
{
    return valueNames<Tool>;
}
template <class Value>
requires(!valueNames<Value>.empty()) constexpr std::string_view name(Value value)
{
    return valueNames<Value>[static_cast<std::size_t>(value)];
}
/// Returns the value of that name, if there is one.
template <class Value> constexpr std::optional<Value> named(std::string_view name)
{
    const auto found = std::ranges::find(valueNames<Value>, name);
    if (found == valueNames<Value>.end())
        return std::nullopt;
    return static_cast<Value>(found - valueNames<Value>.begin());
}

enum class Unit { None, Millimetres, Radii };

/// One row a parameter of a stroke. Panels, settings, VR, the command line and tests read this table.
struct ParameterInfo
{
    std::string_view key; ///< in stroke files and settings
    double defaultValue, min, max;
    Unit unit;
};

enum class Parameter { Radius, Strength, Falloff, Detail, Spacing };
inline constexpr ParameterInfo parameterTable[] = {
    {"radius", 10.0, 1e-6, 1e6, Unit::Millimetres}, {"strength", 1.0, 0.0, 10.0, Unit::None},
    {"falloff", 4.0, 0.0, 16.0, Unit::None}, ///< integer: 0 (no weighting) or 3 to 16
    {"detail", 1.0, 0.05, 20.0, Unit::None},        {"spacing", 0.0, 0.0, 4.0, Unit::Radii},
};
constexpr const ParameterInfo& info(Parameter p)
{
    return parameterTable[static_cast<int>(p)];
}
inline constexpr int minFalloff = 3; ///< but for 0: the paper asks for n > 2
constexpr bool isFalloff(int n)
{
    return n == 0 || (n >= minFalloff && n <= 16);
}

/// b(x) = (n-1) x^n - n x^(n-1) + 1 (paper, section 3.3): 1 at x = 0, 0 at x = 1, flat at both ends. n = 0: always 1.
double falloff(double x, int n);

/// The lengths, in mm, that bound the edges under a brush and the motion of their vertices (paper, sections 3.2, 3.3).
struct EdgeBounds
{
    double detail;  ///< d_detail: no edge under the brush is longer
    double minimum; ///< d: edges under the brush tend not to be shorter

    /// Returns d_move, the longest sub-step of a vertex: 0.45 d. The paper (3.3) asks for less than half the distance
    /// between two neighbours, and measures that distance by d.
    double move() const { return movePerMinimum * minimum; }
    /// Returns d_thickness, the distance below which non-adjacent vertices that face each other may join: 0.735
    /// d_detail. The least with 4 d_move^2 <= d_thickness^2 - d_detail^2 / 3 (paper, 3.3) is 0.732 d_detail.
    double thickness() const { return thicknessPerDetail * detail; }

    static constexpr double minimumPerDetail = 0.5; ///< d in terms of d_detail: the root of the paper's 0.25 (3.2.2)
    static constexpr double movePerMinimum = 0.45, thicknessPerDetail = 0.735;

private:
    static constexpr double movePerDetail = movePerMinimum * minimumPerDetail;
    static_assert(4 * movePerDetail * movePerDetail <= thicknessPerDetail * thicknessPerDetail - 1.0 / 3);
};
/// Returns the bounds for a brush: d_detail^2 = 0.05 r^2 for `detail` 1, d^2 = 0.25 d_detail^2 (paper, section 3.2.2).
/// `radius`: r, in mm. `detail`: factor of d_detail.
EdgeBounds edgeBounds(double radius, double detail);
/// Returns the bounds for a given d_detail.
EdgeBounds edgeBounds(double detailLength);
/// Returns the radius of the brush whose d_detail is that long.
double radiusFor(double detailLength, double detail);
} // namespace core
