#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstddef>
#include <span>

namespace vr
{
/// The inputs and outputs of a wand, or of a bare hand, that Fettle uses. Each hand has all of them.
enum class Control { Grip, Aim, Trigger, Pad, PadTouch, PadPress, Side, Menu, Pulse, Pinch };
inline constexpr std::size_t controlCount = 10;

struct ControlKind
{
    const char* name; ///< name of the action, lower case without spaces, as OpenXR requires
    XrActionType type;
};

/// Kinds of the controls, indexed by Control.
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
    {"pinch", XR_ACTION_TYPE_POSE_INPUT},
}};

/// The part of a wand that serves a control. Paths are relative to the hand's path; null: this hand has no such part.
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

/// One kind of wand: an interaction profile of OpenXR. A runtime knows a profile if it belongs to the core of the
/// OpenXR version in use, or if the extension that defines it is enabled. Others must not be suggested.
struct WandProfile
{
    const char* path;
    bool isStick; ///< see WandState::isStick
    std::span<const Binding> bindings;
    /// First version of OpenXR with the profile in its core; 0: none has it.
    XrVersion core = XR_MAKE_VERSION(1, 0, 0);
    const char* extension = nullptr; ///< extension that defines the profile; null: none

    constexpr bool isInCore(XrVersion version) const { return core != 0 && core <= version; }
};

/// OpenXR's paths of the hands, indexed by Side.
inline constexpr std::array<const char*, 2> handPaths{"/user/hand/left", "/user/hand/right"};

/// Returns all kinds of wands that Fettle has bindings for, the Vive first. The runtime chooses among them.
std::span<const WandProfile> wandProfiles();
} // namespace vr
