#pragma once

#include "core/geometry/geometry.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace core
{
/// The effect of a dab on the vertices it selects. Pull, Push, Flatten, Smooth and Paint are from the paper (sections
/// 3.3, 3.5.3). For the formulas of the others see core/sculpt/deform/deform.cpp.
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

/// Returns whether the tool moves vertices by the motion from sample to sample. The first dab of its stroke moves
/// nothing.
constexpr bool isDragTool(Tool tool)
{
    return tool == Tool::Grab || tool == Tool::SnakeHook || tool == Tool::Twist;
}
/// Returns whether the tool keeps the selection of its first dab for the whole stroke. Other tools select again with
/// each dab.
constexpr bool keepsSelection(Tool tool)
{
    return tool == Tool::Grab || tool == Tool::Twist;
}
/// Returns whether the tool only changes colours or the mask: it moves nothing and remeshes nothing.
constexpr bool paintsAttribute(Tool tool)
{
    return tool == Tool::Paint || tool == Tool::Mask;
}
/// Returns whether an alpha scales the tool's weights. False for tools that keep their selection, because it moves away
/// from under the image, and for Stamp, which has a shape of its own.
constexpr bool usesAlpha(Tool tool)
{
    return !keepsSelection(tool) && tool != Tool::Stamp;
}
/// Returns whether the tool makes sharp edges; it refines the mesh more than others do.
constexpr bool sharpens(Tool tool)
{
    return tool == Tool::Pinch || tool == Tool::Crease;
}
/// Returns whether a stroke of the tool can be a single dab that the user drags to its size (StrokeSettings::anchored).
/// Such tools have an alpha or a model to place.
constexpr bool canAnchor(Tool tool)
{
    return tool == Tool::Stamp || (usesAlpha(tool) && !isDragTool(tool));
}
/// Returns whether the tool can keep applying dabs while the pointer is at rest (StrokeSettings::airbrush).
constexpr bool canAirbrush(Tool tool)
{
    return tool == Tool::Pull || tool == Tool::Push || tool == Tool::Inflate || tool == Tool::Clay ||
           tool == Tool::Smooth || tool == Tool::Pinch || tool == Tool::Paint;
}
/// Returns the share of the radius, 0 to 1, within which all vertices get the full weight; b(x) falls off from there to
/// the rim. Snake Hook's core keeps its shape and stays with the brush. If the weight fell off from the centre, all
/// vertices except the tip would lag behind and the tentacle would become a thread.
constexpr double coreShare(Tool tool)
{
    return tool == Tool::SnakeHook ? 0.5 : 0;
}
/// Returns whether the tool can add a ball or the brush's model (StrokeSettings::add).
constexpr bool canAddSolid(Tool tool)
{
    return tool == Tool::Pull || tool == Tool::Stamp;
}
/// Returns whether StrokeSettings::inverted changes the tool's effect.
constexpr bool hasInverse(Tool tool)
{
    return tool == Tool::Inflate || tool == Tool::Clay || tool == Tool::Layer || tool == Tool::Scrape ||
           tool == Tool::Pinch || tool == Tool::Crease || tool == Tool::Twist || tool == Tool::Stamp ||
           tool == Tool::Mask;
}

/// The rule by which a dab selects vertices (paper, section 3.1).
enum class BrushShape {
    Sphere, ///< vertices within the radius of the centre, by Euclidean distance
    Ray     ///< vertices within the radius of a ray's hit point, by geodesic distance along the surface
};

/// The fineness to which a dab remeshes the surface under the brush.
enum class Topology {
    Refine,   ///< at least as fine as the brush; detail that is already finer is kept
    Adaptive, ///< as fine as the brush, neither finer nor coarser (paper, section 3.2.2)
    Keep,     ///< unchanged, except where a motion would be invalid without remeshing
    Uniform   ///< one edge length for the whole model
};
/// Returns whether detail finer than the brush is kept.
constexpr bool keepsDetail(Topology topology)
{
    return topology == Topology::Refine || topology == Topology::Keep;
}

/// The source of a dab's centre.
enum class Placement {
    Point,   ///< the sample's position, as with a VR controller
    Nearest, ///< the surface point nearest to the sample's position
    Ray      ///< the first hit of position + direction, as with a mouse; no hit: the dab is empty
};

/// The plane through the origin about which a stroke is mirrored (paper, section 3.5.2): x, y or z = 0.
enum class Symmetry { None, X, Y, Z };

/// The names of an enumeration's values in files, in the order of the values.
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
/// Returns the enumeration's value with this name, if there is one.
template <class Value> constexpr std::optional<Value> named(std::string_view name)
{
    const auto found = std::ranges::find(valueNames<Value>, name);
    if (found == valueNames<Value>.end())
        return std::nullopt;
    return static_cast<Value>(found - valueNames<Value>.begin());
}

enum class Unit { None, Millimetres, Radii };

/// One parameter of a stroke: a row of parameterTable, which panels, settings, VR, the command line and tests read.
struct ParameterInfo
{
    std::string_view key; ///< name of the parameter in stroke files and settings
    double defaultValue, min, max;
    Unit unit;
};

enum class Parameter { Radius, Strength, Falloff, Detail, Spacing };
inline constexpr ParameterInfo parameterTable[] = {
    {"radius", 10.0, 1e-6, 1e6, Unit::Millimetres}, {"strength", 1.0, 0.0, 10.0, Unit::None},
    {"falloff", 4.0, 0.0, 16.0, Unit::None}, ///< falloff is an integer: 0 (no weighting) or 3 to 16
    {"detail", 1.0, 0.05, 20.0, Unit::None},        {"spacing", 0.0, 0.0, 4.0, Unit::Radii},
};
constexpr const ParameterInfo& info(Parameter p)
{
    return parameterTable[static_cast<int>(p)];
}
inline constexpr int minFalloff = 3; ///< smallest falloff exponent n except 0; the paper asks for n > 2
constexpr bool isFalloff(int n)
{
    return n == 0 || (n >= minFalloff && n <= 16);
}

/// Returns the weight b(x) = (n-1) x^n - n x^(n-1) + 1 (paper, section 3.3): 1 at x = 0, 0 at x = 1, with slope 0 at
/// both ends. n = 0: always 1.
double falloff(double x, int n);

/// Bounds on the lengths of edges under a brush, and on the motion of their vertices, in mm (paper, sections 3.2, 3.3).
struct EdgeBounds
{
    double detail;  ///< d_detail: no edge under the brush is longer
    double minimum; ///< d: edges under the brush tend not to be shorter

    /// Returns d_move, the longest sub-step of a vertex: 0.45 d. The paper (3.3) asks for less than half the distance
    /// between two neighbours, and takes d for that distance.
    double move() const { return movePerMinimum * minimum; }
    /// Returns d_thickness, the distance below which non-adjacent vertices that face each other may join: 0.735
    /// d_detail. The smallest value allowed by 4 d_move^2 <= d_thickness^2 - d_detail^2 / 3 (paper, 3.3) is 0.732
    /// d_detail.
    double thickness() const { return thicknessPerDetail * detail; }

    static constexpr double minimumPerDetail = 0.5; ///< d / d_detail: the root of the paper's 0.25 (3.2.2)
    static constexpr double movePerMinimum = 0.45, thicknessPerDetail = 0.735;

private:
    static constexpr double movePerDetail = movePerMinimum * minimumPerDetail;
    static_assert(4 * movePerDetail * movePerDetail <= thicknessPerDetail * thicknessPerDetail - 1.0 / 3);
};
/// Returns the edge bounds for a brush: d_detail^2 = 0.05 r^2 for `detail` 1, d^2 = 0.25 d_detail^2 (paper, section
/// 3.2.2). `radius`: r, in mm. `detail`: factor of d_detail.
EdgeBounds edgeBounds(double radius, double detail);
/// Returns the edge bounds for a given d_detail, in mm.
EdgeBounds edgeBounds(double detailLength);
/// Returns the radius, in mm, of the brush whose d_detail is `detailLength` at this detail factor.
double radiusFor(double detailLength, double detail);
} // namespace core
