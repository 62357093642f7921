#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace simulator
{
enum class Hand { Left, Right };
inline constexpr std::array hands{Hand::Left, Hand::Right};

/// Returns the path of a hand, such as "/user/hand/left".
std::string_view userPath(Hand hand);

/// The inputs of a wand, or of a bare hand, that a script can set. Values are 0 to 1, for pads and sticks -1 to 1.
enum class Input {
    Trigger,
    Squeeze,
    PadX,
    PadY,
    PadTouch,
    PadPress,
    StickX,
    StickY,
    StickPress,
    Menu,
    ButtonA,
    ButtonB,
    Pinch, ///< of a bare hand
    Grasp  ///< of a bare hand
};
inline constexpr std::size_t inputCount = 14;

/// An input or output of a wand to which an action is bound.
struct Source
{
    enum class Kind { Boolean, Float, Vector, Grip, Aim, Pinch, Haptic };

    std::string path; ///< full path, such as "/user/hand/left/input/trigger/value"
    Hand hand = Hand::Left;
    Kind kind = Kind::Boolean;
    Input x = Input::Trigger; ///< input of a vector's x, or the only input of another kind
    Input y = Input::Trigger; ///< input of a vector's y
    double threshold = 0.5;   ///< value from which the input counts as pressed
};

/// Returns whether an input of this kind is a pose.
inline bool isPose(Source::Kind kind)
{
    return kind == Source::Kind::Grip || kind == Source::Kind::Aim || kind == Source::Kind::Pinch;
}

struct Component;

/// A kind of wand: an interaction profile of the specification.
struct Profile
{
    std::string_view path;
    std::string_view name; ///< name for display
    std::span<const Component> components;
    /// Full paths that may be bound but are never read, because no hand holds the device.
    std::span<const std::string_view> unread = {};
    /// Minor version of OpenXR 1 from which on the profile is in the core; none: it is in no core.
    std::optional<int> coreMinor = 0;
    std::string_view extension = {}; ///< extension that defines the profile; empty: none
};

std::span<const Profile> profiles();
const Profile* profileAt(std::string_view path);

/// Returns whether the profile has an input or output of this path, or inputs below it.
bool hasPath(const Profile& profile, std::string_view path);

/// Returns what an action of this type reads at a path; none if the value cannot be converted. Precondition: the
/// profile has the path.
std::optional<Source> sourceAt(const Profile& profile, std::string_view path, XrActionType type);
} // namespace simulator
