#pragma once

// Keys of the stroke file, shared by its reader and its writer only.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace core
{
/// A set of keys of one object, one bit for each key.
using KeySet = std::uint64_t;
constexpr KeySet bit(std::size_t key)
{
    return KeySet(1) << key;
}

/// The keys that one kind of object may have; the first `required` of them are mandatory.
template <std::size_t N> struct Keys
{
    std::array<std::string_view, N> names;
    unsigned required;

    int indexOf(std::string_view name) const
    {
        const auto found = std::ranges::find(names, name);
        return found == names.end() ? -1 : static_cast<int>(found - names.begin());
    }
};

enum FileKey { Format, Version, Strokes };
inline constexpr Keys<3> fileKeys{{"format", "version", "strokes"}, 3};

enum StrokeKey {
    ToolKey,
    RadiusKey,
    SamplesKey,
    BrushKey,
    StrengthKey,
    FalloffKey,
    DetailKey,
    DetailLengthKey,
    TopologyKey,
    FusionKey,
    SymmetryKey,
    RadialKey,
    SpacingKey,
    AirbrushKey,
    PlaceKey,
    AddKey,
    JoinKey,
    ColorKey,
    TurntableKey,
    InvertKey,
    AlphaKey,
    AlphaPrintKey,
    AlphaFollowsKey,
    AnchoredKey,
    BrushModelKey,
    BrushModelPrintKey,
    PartKey,
    CommandKey,
    ByKey,
    TurnKey,
    FactorKey,
    PlaneKey,
    KeepKey,
    ModelKey,
    WhereKey,
    CentreKey,
    HeightKey,
    HowKey,
    PartsKey,
    NameKey,
    LockedKey,
    TagKey,
    OperationKey,
    ListPositionKey,
    WhatKey,
    OutlineKey,
    EyeKey,
    AlongKey,
    RemoveKey,
    CombineKey,
    PrimitiveKey,
    WidthKey,
    DepthKey,
    TopRadiusKey,
    TubeRadiusKey,
    ProfileKey,
    PathKey,
    EdgeLengthKey,
    AxisKey,
    StretchKey,
    StretchAxesKey,
    SideKey,
    FrontKey // the keys from CommandKey to here are keys of commands only
};
inline constexpr Keys<63> strokeKeys{{"tool",
                                      "radius",
                                      "samples",
                                      "brush",
                                      "strength",
                                      "falloff",
                                      "detail",
                                      "detail_length",
                                      "topology",
                                      "fusion",
                                      "symmetry",
                                      "radial",
                                      "spacing",
                                      "airbrush",
                                      "place",
                                      "add",
                                      "join",
                                      "color",
                                      "turntable_deg_per_s",
                                      "invert",
                                      "alpha",
                                      "alpha_hash",
                                      "alpha_follows",
                                      "anchored",
                                      "model",
                                      "model_hash",
                                      "part",
                                      "command",
                                      "by",
                                      "rotation",
                                      "factor",
                                      "plane",
                                      "keep",
                                      "file",
                                      "where",
                                      "centre",
                                      "height",
                                      "how",
                                      "parts",
                                      "name",
                                      "locked",
                                      "tag",
                                      "operation",
                                      "list_position",
                                      "what",
                                      "outline",
                                      "eye",
                                      "along",
                                      "remove",
                                      "combine",
                                      "primitive",
                                      "width",
                                      "depth",
                                      "top_radius",
                                      "tube_radius",
                                      "profile",
                                      "path",
                                      "edge_length",
                                      "axis",
                                      "scale",
                                      "scale_axes",
                                      "side",
                                      "front"},
                                     3};

/// The keys that only commands have.
inline constexpr KeySet commandKeys = bit(strokeKeys.names.size()) - bit(CommandKey);

/// The values of the key "how", in the order of MaskOperation::Kind.
inline constexpr std::array<std::string_view, 9> maskChangeNames{"invert", "clear",  "blur",  "sharpen", "grow",
                                                                 "shrink", "cavity", "color", "part"};

/// The values of the key "where", in the order of Insert::Place, and of "combine", in that of Insert::Combination.
inline constexpr std::array<std::string_view, 4> placeNames{"beside", "as_it_is", "centre", "floor"};
inline constexpr std::array<std::string_view, 5> combinationNames{"apart", "join", "subtract", "intersect", "part"};
/// The values of the key "axis".
inline constexpr std::array<std::string_view, 3> axisNames{"x", "y", "z"};

enum SampleKey {
    PositionKey,
    TimeKey,
    DirectionKey,
    PressureKey,
    RotationKey,
    SampleRadiusKey,
    SampleStrengthKey,
    UpKey
};
inline constexpr Keys<8> sampleKeys{{"position", "t", "direction", "pressure", "rotation", "radius", "strength", "up"},
                                    1};
} // namespace core
