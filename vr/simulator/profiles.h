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

/// "/user/hand/left"
std::string_view userPath(Hand hand);

/// What a script can set of one wand: 0 to 1, of pads and sticks -1 to 1.
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
    ButtonB
};
inline constexpr std::size_t inputCount = 12;

/// The way from an action to what it reads or moves.
struct Source
{
    enum class Kind { Boolean, Float, Vector, Grip, Aim, Haptic };

    std::string path; ///< "/user/hand/left/input/trigger/value"
    Hand hand = Hand::Left;
    Kind kind = Kind::Boolean;
    Input x = Input::Trigger; ///< a vector's x, another's only value
    Input y = Input::Trigger; ///< a vector's
    double threshold = 0.5;   ///< from where on it counts as pressed
};

struct Component;

/// A kind of wand, as the specification's interaction profiles list it.
struct Profile
{
    std::string_view path;
    std::string_view name; ///< for people
    std::span<const Component> components;
    std::span<const std::string_view> unread = {}; ///< whole paths that may be bound, of what nobody holds in a hand
};

std::span<const Profile> profiles();
const Profile* profileAt(std::string_view path);

/// Whether the profile has that input or output, or the parent of some inputs.
bool hasPath(const Profile& profile, std::string_view path);

/// What an action of that type reads at that path, which the profile has; none if the value cannot be converted.
std::optional<Source> sourceAt(const Profile& profile, std::string_view path, XrActionType type);
} // namespace simulator
