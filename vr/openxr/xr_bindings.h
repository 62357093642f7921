#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstddef>
#include <span>

namespace vr
{
/// What we ask of a wand; each hand has all of them.
enum class Control { Grip, Aim, Trigger, Pad, PadTouch, PadPress, Side, Menu, Pulse };
inline constexpr std::size_t controlCount = 9;

struct ControlKind
{
    const char* name; ///< OpenXR's rules: a to z and _
    XrActionType type;
};

/// By Control.
inline constexpr std::array<ControlKind, controlCount> controlKinds{{
    {"grip", XR_ACTION_TYPE_POSE_INPUT},
    {"aim", XR_ACTION_TYPE_POSE_INPUT},
    {"trigger", XR_ACTION_TYPE_FLOAT_INPUT},
    {"pad", XR_ACTION_TYPE_VECTOR2F_INPUT},
    {"pad_touch", XR_ACTION_TYPE_BOOLEAN_INPUT},
    {"pad_press", XR_ACTION_TYPE_BOOLEAN_INPUT},
    {"side", XR_ACTION_TYPE_FLOAT_INPUT},
    {"menu", XR_ACTION_TYPE_BOOLEAN_INPUT},
    {"pulse", XR_ACTION_TYPE_VIBRATION_OUTPUT},
}};

/// What of a wand is which control. Paths below the hand's; null: this hand has none.
struct Binding
{
    Control control;
    const char* left;
    const char* right;

    constexpr Binding(Control which, const char* both) : control(which), left(both), right(both) {}
    constexpr Binding(Control which, const char* ofLeft, const char* ofRight)
        : control(which)
        , left(ofLeft)
        , right(ofRight)
    {}
};

/// One kind of wand.
struct WandProfile
{
    const char* path;
    bool isStick; ///< WandState::isStick
    std::span<const Binding> bindings;
};

/// By Side.
inline constexpr std::array<const char*, 2> handPaths{"/user/hand/left", "/user/hand/right"};

/// All kinds that we know, the one we are made for first. A runtime chooses among them.
std::span<const WandProfile> wandProfiles();
} // namespace vr
