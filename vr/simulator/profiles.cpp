#include "vr/simulator/profiles.h"

#include <algorithm>

namespace simulator
{
enum class Where { Both, Left, Right };

struct Component
{
    std::string_view path; ///< path relative to the hand's path
    Source::Kind kind;
    Input input = Input::Trigger;
    Where where = Where::Both;
    double threshold = 0.5;
};

namespace
{
using Kind = Source::Kind;
constexpr double clickOfTrigger = 0.8;
constexpr double touchOfTrigger = 0.01;
/// Threshold of the system button, which no value reaches: the button may be bound, but the runtime keeps it.
constexpr double never = 2;

constexpr Component gripPose{"/input/grip/pose", Kind::Grip};
constexpr Component aimPose{"/input/aim/pose", Kind::Aim};
constexpr Component haptic{"/output/haptic", Kind::Haptic};
constexpr Component menuClick{"/input/menu/click", Kind::Boolean, Input::Menu};
constexpr Component squeezeClick{"/input/squeeze/click", Kind::Boolean, Input::Squeeze};
constexpr Component squeezeValue{"/input/squeeze/value", Kind::Float, Input::Squeeze};
constexpr Component triggerValue{"/input/trigger/value", Kind::Float, Input::Trigger};
constexpr Component triggerClick{"/input/trigger/click", Kind::Boolean, Input::Trigger, Where::Both, clickOfTrigger};
constexpr Component triggerTouch{"/input/trigger/touch", Kind::Boolean, Input::Trigger, Where::Both, touchOfTrigger};
constexpr Component padX{"/input/trackpad/x", Kind::Float, Input::PadX};
constexpr Component padY{"/input/trackpad/y", Kind::Float, Input::PadY};
constexpr Component padClick{"/input/trackpad/click", Kind::Boolean, Input::PadPress};
constexpr Component padTouch{"/input/trackpad/touch", Kind::Boolean, Input::PadTouch};
constexpr Component padForce{"/input/trackpad/force", Kind::Float, Input::PadPress};
constexpr Component stickX{"/input/thumbstick/x", Kind::Float, Input::StickX};
constexpr Component stickY{"/input/thumbstick/y", Kind::Float, Input::StickY};
constexpr Component stickClick{"/input/thumbstick/click", Kind::Boolean, Input::StickPress};
constexpr Component stickTouch{"/input/thumbstick/touch", Kind::Boolean, Input::StickPress};

constexpr Component simple[] = {
    {"/input/select/click", Kind::Boolean, Input::Trigger}, menuClick, gripPose, aimPose, haptic};

constexpr Component vive[] = {{"/input/system/click", Kind::Boolean, Input::Menu, Where::Both, never},
                              squeezeClick,
                              menuClick,
                              triggerClick,
                              triggerValue,
                              padX,
                              padY,
                              padClick,
                              padTouch,
                              gripPose,
                              aimPose,
                              haptic};

constexpr Component index[] = {{"/input/system/click", Kind::Boolean, Input::Menu, Where::Both, never},
                               {"/input/system/touch", Kind::Boolean, Input::Menu, Where::Both, never},
                               {"/input/a/click", Kind::Boolean, Input::ButtonA},
                               {"/input/a/touch", Kind::Boolean, Input::ButtonA},
                               {"/input/b/click", Kind::Boolean, Input::ButtonB},
                               {"/input/b/touch", Kind::Boolean, Input::ButtonB},
                               squeezeValue,
                               {"/input/squeeze/force", Kind::Float, Input::Squeeze},
                               triggerClick,
                               triggerValue,
                               triggerTouch,
                               stickX,
                               stickY,
                               stickClick,
                               stickTouch,
                               padX,
                               padY,
                               padForce,
                               padTouch,
                               gripPose,
                               aimPose,
                               haptic};

constexpr Component touch[] = {{"/input/x/click", Kind::Boolean, Input::ButtonA, Where::Left},
                               {"/input/x/touch", Kind::Boolean, Input::ButtonA, Where::Left},
                               {"/input/y/click", Kind::Boolean, Input::ButtonB, Where::Left},
                               {"/input/y/touch", Kind::Boolean, Input::ButtonB, Where::Left},
                               {"/input/menu/click", Kind::Boolean, Input::Menu, Where::Left},
                               {"/input/a/click", Kind::Boolean, Input::ButtonA, Where::Right},
                               {"/input/a/touch", Kind::Boolean, Input::ButtonA, Where::Right},
                               {"/input/b/click", Kind::Boolean, Input::ButtonB, Where::Right},
                               {"/input/b/touch", Kind::Boolean, Input::ButtonB, Where::Right},
                               {"/input/system/click", Kind::Boolean, Input::Menu, Where::Right, never},
                               {"/input/thumbrest/touch", Kind::Boolean, Input::PadTouch},
                               squeezeValue,
                               triggerValue,
                               triggerTouch,
                               stickX,
                               stickY,
                               stickClick,
                               stickTouch,
                               gripPose,
                               aimPose,
                               haptic};

// Profiles of later extensions list what a client may want of them.
constexpr Component leftX{"/input/x/click", Kind::Boolean, Input::ButtonA, Where::Left};
constexpr Component leftY{"/input/y/click", Kind::Boolean, Input::ButtonB, Where::Left};
constexpr Component leftMenu{"/input/menu/click", Kind::Boolean, Input::Menu, Where::Left};
constexpr Component rightA{"/input/a/click", Kind::Boolean, Input::ButtonA, Where::Right};
constexpr Component rightB{"/input/b/click", Kind::Boolean, Input::ButtonB, Where::Right};

constexpr Component pico[] = {leftX,        leftY,        leftMenu,     rightA,       rightB, squeezeClick,
                              squeezeValue, triggerClick, triggerValue, triggerTouch, stickX, stickY,
                              stickClick,   stickTouch,   gripPose,     aimPose,      haptic};

/// Parts of Pico's Neo3, whose right controller has a menu button, too.
constexpr Component picoNeo3[] = {leftX,        leftY,        menuClick,    rightA,       rightB, squeezeClick,
                                  squeezeValue, triggerClick, triggerValue, triggerTouch, stickX, stickY,
                                  stickClick,   stickTouch,   gripPose,     aimPose,      haptic};

constexpr Component cosmos[] = {leftX,        leftY,        leftMenu,     rightA,  rightB,
                                squeezeClick, triggerClick, triggerValue, stickX,  stickY,
                                stickClick,   stickTouch,   gripPose,     aimPose, haptic};

constexpr Component reverb[] = {leftX,  leftY,  rightA,     rightB,   menuClick, squeezeValue, triggerValue,
                                stickX, stickY, stickClick, gripPose, aimPose,   haptic};

constexpr Component generic[] = {{"/input/primary/click", Kind::Boolean, Input::ButtonA},
                                 {"/input/secondary/click", Kind::Boolean, Input::ButtonB},
                                 squeezeValue,
                                 triggerValue,
                                 stickX,
                                 stickY,
                                 stickClick,
                                 gripPose,
                                 aimPose,
                                 haptic};

constexpr Component frame[] = {{"/input/dpad_up/click", Kind::Boolean, Input::ButtonB, Where::Left},
                               {"/input/dpad_down/click", Kind::Boolean, Input::ButtonA, Where::Left},
                               {"/input/view/click", Kind::Boolean, Input::Menu, Where::Left},
                               {"/input/menu/click", Kind::Boolean, Input::Menu, Where::Right},
                               rightA,
                               {"/input/y/click", Kind::Boolean, Input::ButtonB, Where::Right},
                               squeezeClick,
                               squeezeValue,
                               triggerValue,
                               triggerTouch,
                               stickX,
                               stickY,
                               stickClick,
                               stickTouch,
                               gripPose,
                               aimPose,
                               haptic};

constexpr double tracked = -1; ///< threshold that every value reaches: the fingers are always seen

/// Parts of a bare hand. The poke pose is that of the pinch.
constexpr Component bareHand[] = {
    gripPose,
    aimPose,
    {"/input/pinch_ext/pose", Kind::Pinch},
    {"/input/poke_ext/pose", Kind::Pinch},
    {"/input/pinch_ext/value", Kind::Float, Input::Pinch},
    {"/input/pinch_ext/ready_ext", Kind::Boolean, Input::Pinch, Where::Both, tracked},
    {"/input/aim_activate_ext/value", Kind::Float, Input::Pinch},
    {"/input/aim_activate_ext/ready_ext", Kind::Boolean, Input::Pinch, Where::Both, tracked},
    {"/input/grasp_ext/value", Kind::Float, Input::Grasp},
    {"/input/grasp_ext/ready_ext", Kind::Boolean, Input::Grasp, Where::Both, tracked}};

constexpr Component motion[] = {menuClick, squeezeClick, triggerValue, stickX,   stickY,  stickClick, padX,
                                padY,      padClick,     padTouch,     gripPose, aimPose, haptic};

constexpr Component daydream[] = {
    {"/input/select/click", Kind::Boolean, Input::Trigger}, padX, padY, padClick, padTouch, gripPose, aimPose};

constexpr Component go[] = {{"/input/system/click", Kind::Boolean, Input::Menu, Where::Both, never},
                            {"/input/back/click", Kind::Boolean, Input::Menu},
                            triggerClick,
                            padX,
                            padY,
                            padClick,
                            padTouch,
                            gripPose,
                            aimPose};

constexpr std::string_view vivePro[] = {"/user/head/input/system/click", "/user/head/input/volume_up/click",
                                        "/user/head/input/volume_down/click", "/user/head/input/mute_mic/click"};

constexpr std::string_view gamepad[] = {"/user/gamepad/input/menu/click",
                                        "/user/gamepad/input/view/click",
                                        "/user/gamepad/input/a/click",
                                        "/user/gamepad/input/b/click",
                                        "/user/gamepad/input/x/click",
                                        "/user/gamepad/input/y/click",
                                        "/user/gamepad/input/dpad_down/click",
                                        "/user/gamepad/input/dpad_right/click",
                                        "/user/gamepad/input/dpad_up/click",
                                        "/user/gamepad/input/dpad_left/click",
                                        "/user/gamepad/input/shoulder_left/click",
                                        "/user/gamepad/input/shoulder_right/click",
                                        "/user/gamepad/input/thumbstick_left/x",
                                        "/user/gamepad/input/thumbstick_left/y",
                                        "/user/gamepad/input/thumbstick_left/click",
                                        "/user/gamepad/input/thumbstick_right/x",
                                        "/user/gamepad/input/thumbstick_right/y",
                                        "/user/gamepad/input/thumbstick_right/click",
                                        "/user/gamepad/input/trigger_left/value",
                                        "/user/gamepad/input/trigger_right/value",
                                        "/user/gamepad/output/haptic_left",
                                        "/user/gamepad/output/haptic_right",
                                        "/user/gamepad/output/haptic_left_trigger",
                                        "/user/gamepad/output/haptic_right_trigger"};

constexpr Profile known[] = {
    {"/interaction_profiles/htc/vive_controller", "Vive Controller", vive},
    {"/interaction_profiles/khr/simple_controller", "Simple Controller", simple},
    {"/interaction_profiles/valve/index_controller", "Index Controller", index},
    {"/interaction_profiles/oculus/touch_controller", "Touch Controller", touch},
    {"/interaction_profiles/microsoft/motion_controller", "Mixed Reality Controller", motion},
    {"/interaction_profiles/google/daydream_controller", "Daydream Controller", daydream},
    {"/interaction_profiles/oculus/go_controller", "Go Controller", go},
    {"/interaction_profiles/htc/vive_pro", "Vive Pro", {}, vivePro},
    {"/interaction_profiles/microsoft/xbox_controller", "Xbox Controller", {}, gamepad},
    {"/interaction_profiles/htc/vive_cosmos_controller",
     "Cosmos Controller",
     cosmos,
     {},
     1,
     "XR_HTC_vive_cosmos_controller_interaction"},
    {"/interaction_profiles/htc/vive_focus3_controller",
     "Focus 3 Controller",
     pico,
     {},
     1,
     "XR_HTC_vive_focus3_controller_interaction"},
    {"/interaction_profiles/valve/frame_controller_valve",
     "Frame Controller",
     frame,
     {},
     {},
     "XR_VALVE_frame_controller_interaction"},
    {"/interaction_profiles/meta/touch_plus_controller", "Touch Plus Controller", touch, {}, 1},
    {"/interaction_profiles/meta/touch_controller_plus",
     "Touch Plus Controller",
     touch,
     {},
     {},
     "XR_META_touch_controller_plus"},
    {"/interaction_profiles/meta/touch_pro_controller", "Touch Pro Controller", touch, {}, 1},
    {"/interaction_profiles/facebook/touch_controller_pro",
     "Touch Pro Controller",
     touch,
     {},
     {},
     "XR_FB_touch_controller_pro"},
    {"/interaction_profiles/bytedance/pico_neo3_controller",
     "Neo3 Controller",
     picoNeo3,
     {},
     1,
     "XR_BD_controller_interaction"},
    {"/interaction_profiles/bytedance/pico4_controller",
     "Pico 4 Controller",
     pico,
     {},
     1,
     "XR_BD_controller_interaction"},
    {"/interaction_profiles/bytedance/pico_ultra_controller_bd",
     "Pico Ultra Controller",
     pico,
     {},
     {},
     "XR_BD_ultra_controller_interaction"},
    {"/interaction_profiles/hp/mixed_reality_controller",
     "Reverb Controller",
     reverb,
     {},
     1,
     "XR_EXT_hp_mixed_reality_controller"},
    {"/interaction_profiles/khr/generic_controller",
     "Generic Controller",
     generic,
     {},
     {},
     "XR_KHR_generic_controller"},
    {"/interaction_profiles/ext/hand_interaction_ext", "Hand", bareHand, {}, {}, "XR_EXT_hand_interaction"},
};

/// A full path, cut after the hand.
struct HandPath
{
    Hand hand;
    std::string_view rest;
};

std::optional<HandPath> cut(std::string_view path)
{
    for (const Hand hand : hands) {
        if (path.starts_with(userPath(hand)))
            return HandPath{hand, path.substr(userPath(hand).size())};
    }
    return {};
}

bool isOn(const Component& component, Hand hand)
{
    return component.where == Where::Both || (component.where == Where::Left) == (hand == Hand::Left);
}

/// Returns the parent of a path: "/input/trigger" for "/input/trigger/value".
std::string_view parentOf(std::string_view path)
{
    const std::string_view parent = path.substr(0, path.rfind('/'));
    return parent.ends_with("/input") || parent.ends_with("/output") ? std::string_view() : parent;
}

const Component* find(const Profile& profile, Hand hand, std::string_view path)
{
    const auto found = std::find_if(profile.components.begin(), profile.components.end(),
                                    [&](const Component& it) { return it.path == path && isOn(it, hand); });
    return found == profile.components.end() ? nullptr : &*found;
}

/// Returns the first of these children that the parent has; null if it has none.
const Component* childOf(const Profile& profile, const HandPath& parent, std::initializer_list<std::string_view> names)
{
    for (const std::string_view name : names) {
        if (const Component* child = find(profile, parent.hand, std::string(parent.rest) + std::string(name)))
            return child;
    }
    return nullptr;
}

const Component* componentFor(const Profile& profile, const HandPath& at, XrActionType type)
{
    if (const Component* component = find(profile, at.hand, at.rest))
        return component;
    switch (type) {
    case XR_ACTION_TYPE_BOOLEAN_INPUT:
        return childOf(profile, at, {"/click", "/value"});
    case XR_ACTION_TYPE_FLOAT_INPUT:
        return childOf(profile, at, {"/value", "/click"});
    case XR_ACTION_TYPE_POSE_INPUT:
        return childOf(profile, at, {"/pose"});
    default:
        return nullptr;
    }
}

bool suits(Source::Kind kind, XrActionType type)
{
    switch (type) {
    case XR_ACTION_TYPE_BOOLEAN_INPUT:
    case XR_ACTION_TYPE_FLOAT_INPUT:
        return kind == Kind::Boolean || kind == Kind::Float;
    case XR_ACTION_TYPE_POSE_INPUT:
        return isPose(kind);
    case XR_ACTION_TYPE_VIBRATION_OUTPUT:
        return kind == Kind::Haptic;
    default:
        return false;
    }
}

std::string wholePath(const HandPath& at, std::string_view rest)
{
    return std::string(userPath(at.hand)) + std::string(rest);
}

std::optional<Source> vectorAt(const Profile& profile, const HandPath& at)
{
    const Component* x = childOf(profile, at, {"/x"});
    const Component* y = childOf(profile, at, {"/y"});
    if (!x || !y)
        return {};
    return Source{wholePath(at, at.rest), at.hand, Kind::Vector, x->input, y->input};
}
} // namespace

std::string_view userPath(Hand hand)
{
    return hand == Hand::Left ? "/user/hand/left" : "/user/hand/right";
}

std::span<const Profile> profiles()
{
    return known;
}

const Profile* profileAt(std::string_view path)
{
    const auto found =
        std::find_if(std::begin(known), std::end(known), [&](const Profile& it) { return it.path == path; });
    return found == std::end(known) ? nullptr : found;
}

bool hasPath(const Profile& profile, std::string_view path)
{
    const auto at = cut(path);
    if (!at || at->rest.empty())
        return std::any_of(profile.unread.begin(), profile.unread.end(),
                           [&](auto it) { return it == path || parentOf(it) == path; });
    return std::any_of(profile.components.begin(), profile.components.end(), [&](const Component& it) {
        return isOn(it, at->hand) && (it.path == at->rest || parentOf(it.path) == at->rest);
    });
}

std::optional<Source> sourceAt(const Profile& profile, std::string_view path, XrActionType type)
{
    const auto at = cut(path);
    if (!at)
        return {};
    if (type == XR_ACTION_TYPE_VECTOR2F_INPUT)
        return vectorAt(profile, *at);
    const Component* component = componentFor(profile, *at, type);
    if (!component || !suits(component->kind, type))
        return {};
    return Source{wholePath(*at, component->path),
                  at->hand,
                  component->kind,
                  component->input,
                  component->input,
                  component->threshold};
}
} // namespace simulator
