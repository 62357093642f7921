#include "vr/simulator/script_devices.h"

#include "vr/simulator/runtime.h"
#include "vr/simulator/script_values.h"

namespace simulator
{
namespace
{
using nlohmann::json;

using HeadOrHand = std::function<Motion&(SimulatedWorld&)>;

Change motionChange(const std::string& key, const json& value, Over over, const HeadOrHand& of)
{
    if (key == "position") {
        return [of, over, to = readVector(value)](Runtime& runtime, XrTime start) {
            of(runtime.world).position.moveTo(to, start, over * runtime.world.period());
        };
    }
    return [of, over, to = readRotation(key, value)](Runtime& runtime, XrTime start) {
        of(runtime.world).rotation.moveTo(to, start, over * runtime.world.period());
    };
}

bool isMotion(const std::string& key)
{
    return key == "position" || key == "rotation" || key == "yaw_pitch_roll";
}

Change all(ScriptStep changes)
{
    return [changes = std::move(changes)](Runtime& runtime, XrTime start) {
        for (const Change& change : changes)
            change(runtime, start);
    };
}

struct NamedInput
{
    std::string_view key;
    Input first;
    bool isPair = false; ///< `first` is the x of a pair; the next Input is its y
};

constexpr NamedInput namedInputs[] = {
    {"trigger", Input::Trigger},        {"squeeze", Input::Squeeze},    {"pad", Input::PadX, true},
    {"pad_touch", Input::PadTouch},     {"pad_press", Input::PadPress}, {"stick", Input::StickX, true},
    {"stick_press", Input::StickPress}, {"menu", Input::Menu},          {"button_a", Input::ButtonA},
    {"button_b", Input::ButtonB},       {"pinch", Input::Pinch},        {"grasp", Input::Grasp},
};

Change inputChange(const std::string& key, const json& value, Over over, Hand hand)
{
    for (const NamedInput& named : namedInputs) {
        if (named.key != key)
            continue;
        const std::vector<double> to = named.isPair ? readNumbers(value, 2) : std::vector{readAmount(value)};
        return [=](Runtime& runtime, XrTime start) {
            for (std::size_t i = 0; i < to.size(); ++i) {
                runtime.world.wands[static_cast<std::size_t>(hand)]
                    .inputs[static_cast<std::size_t>(named.first) + i]
                    .moveTo(to[i], start, over * runtime.world.period());
            }
        };
    }
    notUnderstood(key);
}
} // namespace

Change headChange(const nlohmann::json& value, Over over)
{
    ScriptStep changes;
    for (const auto& [key, part] : members(value)) {
        if (isMotion(key)) {
            changes.push_back(
                motionChange(key, part, over, [](SimulatedWorld& world) -> Motion& { return world.head.motion; }));
        } else if (key == "tracked") {
            changes.push_back(
                [tracking = readTracking(part)](Runtime& runtime, XrTime) { runtime.world.head.tracking = tracking; });
        } else {
            notUnderstood(key);
        }
    }
    return all(std::move(changes));
}

Change wandChange(const nlohmann::json& value, Over over, Hand hand)
{
    const auto at = static_cast<std::size_t>(hand);
    ScriptStep changes;
    for (const auto& [key, part] : members(value)) {
        if (isMotion(key))
            changes.push_back(
                motionChange(key, part, over, [at](SimulatedWorld& world) -> Motion& { return world.wands[at].grip; }));
        else if (key == "tracked")
            changes.push_back([at, tracking = readTracking(part)](Runtime& runtime, XrTime) {
                runtime.world.wands[at].tracking = tracking;
            });
        else if (key == "on")
            changes.push_back(
                [at, on = readBool(part)](Runtime& runtime, XrTime) { runtime.world.wands[at].isOn = on; });
        else
            changes.push_back(inputChange(key, part, over, hand));
    }
    return all(std::move(changes));
}
} // namespace simulator
