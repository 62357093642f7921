// Paths are from section 6.4 of the OpenXR specification, "Interaction Profile Paths", and from the section of each
// extension, as of version 1.1.62. XR_VALVE_frame_controller_interaction is not in the specification; its paths are
// those of Valve's OpenXR package for Unity. Names of extensions are written out, because older headers lack most.
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

constexpr std::array<Binding, 9> stickWand(const Binding& side, const Binding& menu)
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

constexpr Binding squeezeValue{Control::Side, "/input/squeeze/value"};
constexpr Binding squeezeClick{Control::Side, "/input/squeeze/click"};
/// The upper buttons, which are at the same place in both hands. They serve as menu buttons where only the left wand
/// has one.
constexpr Binding upperButtons{Control::Menu, "/input/y/click", "/input/b/click"};

/// Bindings of Valve's Index. A squeeze is measured by force, because the grip senses every finger that touches it. The
/// system reserves the menu button, so B is used as menu.
constexpr auto index = stickWand({Control::Side, "/input/squeeze/force"}, {Control::Menu, "/input/b/click"});

/// Bindings of Valve's Frame controllers. The right one has four buttons, the left one a pad of four directions. The
/// top one of either serves as menu button, because SteamVR may keep View and Menu for itself.
constexpr auto frame = stickWand(squeezeValue, {Control::Menu, "/input/dpad_up/click", "/input/y/click"});

/// Bindings of Meta's Touch controllers, of Pico's and of the Vive Focus 3's.
constexpr auto touch = stickWand(squeezeValue, upperButtons);

/// Bindings of the Vive Cosmos.
constexpr auto cosmos = stickWand(squeezeClick, upperButtons);

/// Bindings of wands with a thumbstick that does not sense touches.
constexpr std::array<Binding, 8> touchlessStickWand(const Binding& menu)
{
    return {{grip,
             aim,
             trigger,
             {Control::Pad, "/input/thumbstick"},
             {Control::PadPress, "/input/thumbstick/click"},
             squeezeValue,
             menu,
             pulse}};
}

/// Bindings of HP's Reverb.
constexpr auto reverb = touchlessStickWand({Control::Menu, "/input/menu/click"});

/// Bindings of Khronos' generic controller, for which runtimes may pass off wands that Fettle does not know. It has no
/// menu button.
constexpr auto generic = touchlessStickWand({Control::Menu, "/input/secondary/click"});

constexpr Binding simple[]{
    grip, aim, {Control::Trigger, "/input/select/click"}, {Control::Menu, "/input/menu/click"}, pulse,
};

/// Bindings of bare hands. They have no buttons: vr/input/bare_hand.h reads the palm as menu button.
constexpr Binding bareHand[]{
    grip,
    aim,
    {Control::Trigger, "/input/pinch_ext/value"},
    {Control::Side, "/input/grasp_ext/value"},
    {Control::Pinch, "/input/pinch_ext/pose"},
};

constexpr XrVersion in10 = XR_MAKE_VERSION(1, 0, 0), in11 = XR_MAKE_VERSION(1, 1, 0), inNone = 0;

// OpenXR 1.1 renamed two profiles of Meta when it took them over: they have a row for each name.
constexpr WandProfile profiles[]{
    {"/interaction_profiles/htc/vive_controller", false, trackpadWand, in10},
    {"/interaction_profiles/htc/vive_cosmos_controller", true, cosmos, in11,
     "XR_HTC_vive_cosmos_controller_interaction"},
    {"/interaction_profiles/htc/vive_focus3_controller", true, touch, in11,
     "XR_HTC_vive_focus3_controller_interaction"},
    {"/interaction_profiles/valve/index_controller", true, index, in10},
    {"/interaction_profiles/valve/frame_controller_valve", true, frame, inNone,
     "XR_VALVE_frame_controller_interaction"},
    {"/interaction_profiles/oculus/touch_controller", true, touch, in10},
    {"/interaction_profiles/meta/touch_plus_controller", true, touch, in11},
    {"/interaction_profiles/meta/touch_controller_plus", true, touch, inNone, "XR_META_touch_controller_plus"},
    {"/interaction_profiles/meta/touch_pro_controller", true, touch, in11},
    {"/interaction_profiles/facebook/touch_controller_pro", true, touch, inNone, "XR_FB_touch_controller_pro"},
    {"/interaction_profiles/bytedance/pico_neo3_controller", true, touch, in11, "XR_BD_controller_interaction"},
    {"/interaction_profiles/bytedance/pico4_controller", true, touch, in11, "XR_BD_controller_interaction"},
    {"/interaction_profiles/bytedance/pico_ultra_controller_bd", true, touch, inNone,
     "XR_BD_ultra_controller_interaction"},
    {"/interaction_profiles/microsoft/motion_controller", false, trackpadWand, in10},
    {"/interaction_profiles/hp/mixed_reality_controller", true, reverb, in11, "XR_EXT_hp_mixed_reality_controller"},
    {"/interaction_profiles/khr/generic_controller", true, generic, inNone, "XR_KHR_generic_controller"},
    {"/interaction_profiles/khr/simple_controller", false, simple, in10},
    {"/interaction_profiles/ext/hand_interaction_ext", false, bareHand, inNone, "XR_EXT_hand_interaction"},
};
} // namespace

std::span<const WandProfile> wandProfiles()
{
    return profiles;
}
} // namespace vr
