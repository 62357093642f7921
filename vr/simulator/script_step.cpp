#include "vr/simulator/script_step.h"

#include "vr/simulator/enum_names.h"
#include "vr/simulator/instance.h"
#include "vr/simulator/runtime.h"
#include "vr/simulator/script_devices.h"
#include "vr/simulator/script_values.h"

#include <chrono>
#include <cstdlib>
#include <thread>

namespace simulator
{
namespace
{
using nlohmann::json;

using Reader = Change (*)(const json& value, Over over);

template <auto Member> Change flag(const json& value, Over)
{
    return [on = readBool(value)](Runtime& runtime, XrTime) { runtime.world.*Member = on; };
}

Change sizeChange(const json& value, Over)
{
    const std::vector<double> size = readNumbers(value, 2);
    return [size](Runtime& runtime, XrTime) {
        runtime.world.headset.width = static_cast<int>(size[0]);
        runtime.world.headset.height = static_cast<int>(size[1]);
    };
}

Change hertzChange(const json& value, Over)
{
    return [hertz = readPositive(value)](Runtime& runtime, XrTime) { runtime.world.headset.hertz = hertz; };
}

/// Sets the minor versions of OpenXR 1 that are accepted.
Change minorsChange(const json& value, Over)
{
    std::set<std::uint64_t> minors;
    for (const json& minor : value)
        minors.insert(static_cast<std::uint64_t>(readCount(minor)));
    return [minors](Runtime& runtime, XrTime) { runtime.world.minors = minors; };
}

Change withheldChange(const json& value, Over)
{
    std::set<std::string, std::less<>> withheld;
    for (const json& name : value)
        withheld.insert(readText(name));
    return [withheld](Runtime& runtime, XrTime) { runtime.world.withheld = withheld; };
}

Change failingFormatsChange(const json& value, Over)
{
    const std::map<std::string, std::int64_t> names{{"srgb8_alpha8", 0x8C43}, // GL_SRGB8_ALPHA8
                                                    {"rgba16f", 0x881A},      // GL_RGBA16F
                                                    {"rgba8", 0x8058},        // GL_RGBA8
                                                    {"depth24", 0x81A6},      // GL_DEPTH_COMPONENT24
                                                    {"depth32f", 0x8CAC}};    // GL_DEPTH_COMPONENT32F
    std::set<std::int64_t> failing;
    for (const json& name : value)
        failing.insert(readOneOf(name, names));
    return [failing](Runtime& runtime, XrTime) { runtime.world.failingFormats = failing; };
}

Change blendModesChange(const json& value, Over)
{
    std::vector<XrEnvironmentBlendMode> modes;
    for (const json& name : value)
        modes.push_back(
            readOneOf<XrEnvironmentBlendMode>(name, {{"opaque", XR_ENVIRONMENT_BLEND_MODE_OPAQUE},
                                                     {"additive", XR_ENVIRONMENT_BLEND_MODE_ADDITIVE},
                                                     {"alpha_blend", XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND}}));
    return [modes](Runtime& runtime, XrTime) { runtime.world.blendModes = modes; };
}

Change minOpenGlChange(const json& value, Over)
{
    const std::vector<double> version = readNumbers(value, 2);
    const XrVersion least =
        XR_MAKE_VERSION(static_cast<std::uint64_t>(version[0]), static_cast<std::uint64_t>(version[1]), 0);
    return [least](Runtime& runtime, XrTime) { runtime.world.minOpenGl = least; };
}

Change ratesChange(const json& value, Over)
{
    std::vector<float> rates;
    for (const json& rate : value)
        rates.push_back(static_cast<float>(readPositive(rate)));
    return [rates](Runtime& runtime, XrTime) { runtime.world.headset.otherRates = rates; };
}

Change viewsChange(const json& value, Over)
{
    const Views views =
        readOneOf<Views>(value, {{"stereo", Views::Stereo}, {"mono", Views::Mono}, {"mono_first", Views::MonoFirst}});
    return [views](Runtime& runtime, XrTime) { runtime.world.headset.views = views; };
}

Change eyeDistanceChange(const json& value, Over)
{
    return [metres = readPositive(value)](Runtime& runtime, XrTime) { runtime.world.headset.eyeDistance = metres; };
}

Change fovChange(const json& value, Over)
{
    const std::vector<double> degrees = readNumbers(value, 4);
    const auto radians = [&](std::size_t i) { return static_cast<float>(degrees[i] * radiansPerDegree); };
    const XrFovf fov{radians(0), radians(1), radians(2), radians(3)};
    return [fov](Runtime& runtime, XrTime) { runtime.world.headset.fov = fov; };
}

Change hiddenChange(const json& value, Over)
{
    return [share = readAmount(value)](Runtime& runtime, XrTime) { runtime.hide(share); };
}

Change paceChange(const json& value, Over)
{
    const Pace pace = readOneOf<Pace>(
        value, {{"real", Pace::Real}, {"live", Pace::Live}, {"fast", Pace::Fast}, {"stepped", Pace::Stepped}});
    return [pace](Runtime& runtime, XrTime) { runtime.world.pace = pace; };
}

Change boundsChange(const json& value, Over)
{
    std::optional<XrExtent2Df> bounds;
    if (!value.is_null()) {
        const std::vector<double> size = readNumbers(value, 2);
        bounds = XrExtent2Df{static_cast<float>(size[0]), static_cast<float>(size[1])};
    }
    return [bounds](Runtime& runtime, XrTime) { runtime.world.bounds = bounds; };
}

Change profileChange(const json& value, Over)
{
    const std::string path = readText(value);
    if (!profileAt(path))
        throw std::runtime_error(path + " is no profile that is known here");
    return [path](Runtime& runtime, XrTime) { runtime.world.profile = path; };
}

Change aimChange(const json& value, Over)
{
    return [pose = readPose(value)](Runtime& runtime, XrTime) { runtime.world.aim = pose; };
}

Change pinchChange(const json& value, Over)
{
    return [pose = readPose(value)](Runtime& runtime, XrTime) { runtime.world.pinch = pose; };
}

Change lateChange(const json& value, Over)
{
    const auto late = static_cast<XrDuration>(readPositive(value) * 1e6);
    return [late](Runtime& runtime, XrTime) { runtime.world.late = late; };
}

Change recentreChange(const json& value, Over)
{
    const std::map<std::string, XrReferenceSpaceType> spaces{{"local", XR_REFERENCE_SPACE_TYPE_LOCAL},
                                                             {"stage", XR_REFERENCE_SPACE_TYPE_STAGE}};
    Recentring recentring;
    for (const auto& [key, part] : members(value)) {
        if (key == "space")
            recentring.space = readOneOf(part, spaces);
        else if (key == "after")
            recentring.after = readCount(part);
        else if (key == "position")
            recentring.origin.position = readVector(part);
        else
            recentring.origin.rotation = readRotation(key, part);
    }
    return [recentring](Runtime& runtime, XrTime) { runtime.recentre(recentring); };
}

Change loseSession(const json& value, Over)
{
    return [after = readCount(value)](Runtime& runtime, XrTime) { runtime.loseSession(after); };
}

Change loseInstance(const json& value, Over)
{
    return [after = readCount(value)](Runtime& runtime, XrTime) { runtime.loseInstance(after); };
}

Change loseEvents(const json& value, Over)
{
    return [loses = readBool(value)](Runtime& runtime, XrTime) {
        if (loses && runtime.instance)
            runtime.instance->events.lose();
    };
}

Change exitChange(const json& value, Over)
{
    return [exits = readBool(value)](Runtime& runtime, XrTime) {
        if (exits)
            runtime.exitSession();
    };
}

/// Keeps pictures of the listed frames. The value true means the next frame.
Change keepChange(const json& value, Over)
{
    std::vector<std::int64_t> frames;
    if (value.is_array())
        std::transform(value.begin(), value.end(), std::back_inserter(frames), readCount);
    else if (!readBool(value))
        throw std::runtime_error("keep: true, or a list of frames");
    return [frames](Runtime& runtime, XrTime) {
        runtime.world.keptFrames.insert(frames.begin(), frames.end());
        if (frames.empty())
            runtime.world.keptFrames.insert(runtime.nextFrame());
    };
}

Change keepEveryChange(const json& value, Over)
{
    return [every = readCount(value)](Runtime& runtime, XrTime) { runtime.world.keepEvery = static_cast<int>(every); };
}

Change failChange(const json& value, Over)
{
    std::string call;
    ScriptedResult scripted;
    for (const auto& [key, part] : members(value)) {
        if (key == "call") {
            call = readText(part);
        } else if (key == "times") {
            scripted.times = static_cast<int>(readCount(part));
        } else if (key == "after") {
            scripted.after = static_cast<int>(readCount(part));
        } else if (key == "result") {
            const auto result = resultNamed(readText(part));
            if (!result)
                throw std::runtime_error(readText(part) + " is no XrResult");
            scripted.result = *result;
        } else {
            notUnderstood(key);
        }
    }
    return [call, scripted](Runtime& runtime, XrTime) { runtime.world.scriptedResults[call] = scripted; };
}

Change freezeChange(const json& value, Over)
{
    return [call = readText(value)](Runtime& runtime, XrTime) { runtime.world.frozen = call; };
}

void wakeAtExit()
{
    Runtime& runtime = Runtime::get();
    {
        const std::lock_guard lock(runtime.mutex);
        runtime.world.frozen.clear();
        runtime.changed.notify_all();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
}

Change wakeChange(const json& value, Over)
{
    return [wakes = readBool(value)](Runtime&, XrTime) {
        if (wakes)
            std::atexit(wakeAtExit);
    };
}

const std::map<std::string_view, Reader>& vocabulary()
{
    static const std::map<std::string_view, Reader> readers{
        {"runtime", flag<&SimulatedWorld::hasRuntime>},
        {"headset", flag<&SimulatedWorld::hasHeadset>},
        {"opengl", flag<&SimulatedWorld::hasOpenGl>},
        {"least_opengl", minOpenGlChange},
        {"extensions", flag<&SimulatedWorld::hasExtensions>},
        {"withheld", withheldChange},
        {"blend_modes", blendModesChange},
        {"failing_formats", failingFormatsChange},
        {"api_minors", minorsChange},
        {"stage", flag<&SimulatedWorld::hasStage>},
        {"local_floor", flag<&SimulatedWorld::hasLocalFloor>},
        {"worn", flag<&SimulatedWorld::isWorn>},
        {"visible", flag<&SimulatedWorld::isVisible>},
        {"focus", flag<&SimulatedWorld::hasFocus>},
        {"should_render", flag<&SimulatedWorld::shouldRender>},
        {"head", headChange},
        {"left", [](const json& value, Over over) { return wandChange(value, over, Hand::Left); }},
        {"right", [](const json& value, Over over) { return wandChange(value, over, Hand::Right); }},
        {"aim", aimChange},
        {"pinch_at", pinchChange},
        {"profile", profileChange},
        {"size", sizeChange},
        {"hz", hertzChange},
        {"rates", ratesChange},
        {"views", viewsChange},
        {"eye_distance", eyeDistanceChange},
        {"fov", fovChange},
        {"hidden", hiddenChange},
        {"pace", paceChange},
        {"late_ms", lateChange},
        {"bounds", boundsChange},
        {"recentre", recentreChange},
        {"lose_session", loseSession},
        {"lose_instance", loseInstance},
        {"exit", exitChange},
        {"lose_events", loseEvents},
        {"keep", keepChange},
        {"keep_every", keepEveryChange},
        {"watch_drawing", flag<&SimulatedWorld::watchesDrawing>},
        {"fail", failChange},
        {"freeze", freezeChange},
        {"wake_at_exit", wakeChange},
    };
    return readers;
}
} // namespace

ScriptStep readStep(const json& step)
{
    const Over over = step.is_object() && step.contains("over") ? readCount(step["over"]) : 0;
    ScriptStep changes;
    for (const auto& [key, value] : members(step)) {
        if (key == "over")
            continue;
        const auto reader = vocabulary().find(key);
        if (reader == vocabulary().end())
            notUnderstood(key);
        changes.push_back(reader->second(value, over));
    }
    return changes;
}
} // namespace simulator
