// Paths are from section 6.4 of the OpenXR specification, "Interaction Profile Paths".
#include "vr/openxr/xr_bindings.h"

namespace vr
{
namespace
{
constexpr Binding grip{Control::Grip, "/input/grip/pose"};
constexpr Binding aim{Control::Aim, "/input/aim/pose"};
constexpr Binding trigger{Control::Trigger, "/input/trigger/value"};
constexpr Binding pulse{Control::Pulse, "/output/haptic"};

/// Bindings of HTC's Vive wands and Microsoft's motion controllers.
constexpr Binding trackpadWand[]{
    grip,
    aim,
    trigger,
    {Control::Pad, "/input/trackpad"},
    {Control::PadTouch, "/input/trackpad/touch"},
    {Control::PadPress, "/input/trackpad/click"},
    {Control::Side, "/input/squeeze/click"},
    {Control::Menu, "/input/menu/click"},
    pulse,
};

constexpr std::array<Binding, controlCount> stickWand(const Binding& side, const Binding& menu)
{
    return {{grip,
             aim,
             trigger,
             {Control::Pad, "/input/thumbstick"},
             {Control::PadTouch, "/input/thumbstick/touch"},
             {Control::PadPress, "/input/thumbstick/click"},
             side,
             menu,
             pulse}};
}

/// Bindings of Valve's Index. A squeeze is measured by force, because the grip senses every finger that touches it. The
/// system reserves the menu button, so B is used as menu.
constexpr auto index = stickWand({Control::Side, "/input/squeeze/force"}, {Control::Menu, "/input/b/click"});

/// Bindings of Oculus Touch. Only the left wand has a menu button, so Y and B are used, which are at the same place in
/// both hands.
constexpr auto touch =
    stickWand({Control::Side, "/input/squeeze/value"}, {Control::Menu, "/input/y/click", "/input/b/click"});

constexpr Binding simple[]{
    grip, aim, {Control::Trigger, "/input/select/click"}, {Control::Menu, "/input/menu/click"}, pulse,
};

constexpr WandProfile profiles[]{
    {"/interaction_profiles/htc/vive_controller", false, trackpadWand},
    {"/interaction_profiles/valve/index_controller", true, index},
    {"/interaction_profiles/oculus/touch_controller", true, touch},
    {"/interaction_profiles/microsoft/motion_controller", false, trackpadWand},
    {"/interaction_profiles/khr/simple_controller", false, simple},
};
} // namespace

std::span<const WandProfile> wandProfiles()
{
    return profiles;
}
} // namespace vr
