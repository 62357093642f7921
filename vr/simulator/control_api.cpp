#include "vr/simulator/control_api.h"

#include "vr/simulator/runtime.h"
#include "vr/simulator/session.h"

#include <chrono>
#include <utility>

using simulator::Runtime;

namespace
{
thread_local std::string lastText;

const char* kept(std::string text)
{
    lastText = std::move(text);
    return lastText.c_str();
}

template <class Work> const char* errorOf(Work work)
{
    try {
        Runtime& runtime = Runtime::get();
        const std::lock_guard lock(runtime.mutex);
        work(runtime);
        return nullptr;
    } catch (const std::exception& exception) {
        return kept(exception.what());
    }
}

/// Returns whether the client waits for the next frame or has stopped. With other paces than Stepped, returns true.
bool isAtRest(const Runtime& runtime)
{
    const bool isRunning = runtime.session && runtime.session->isRunning();
    return runtime.world.pace != simulator::Pace::Stepped || !isRunning || runtime.isClientWaiting;
}
} // namespace

extern "C" {
__attribute__((visibility("default"))) const char* fettle_xr_load(const char* script)
{
    return errorOf([script](Runtime& runtime) { runtime.load(script); });
}

__attribute__((visibility("default"))) const char* fettle_xr_do(const char* step)
{
    return errorOf([step](Runtime& runtime) { runtime.apply(simulator::readStep(nlohmann::json::parse(step))); });
}

__attribute__((visibility("default"))) int fettle_xr_frames(int count, int milliseconds)
{
    Runtime& runtime = Runtime::get();
    std::unique_lock lock(runtime.mutex);
    const std::int64_t first = runtime.framesEnded;
    if (runtime.world.pace == simulator::Pace::Stepped)
        runtime.framesAllowed += count;
    runtime.changed.notify_all();
    runtime.changed.wait_for(lock, std::chrono::milliseconds(milliseconds),
                             [&] { return runtime.framesEnded >= first + count && isAtRest(runtime); });
    return static_cast<int>(runtime.framesEnded - first);
}

__attribute__((visibility("default"))) const FettleXrPicture* fettle_xr_picture()
{
    thread_local simulator::Picture shown;
    thread_local FettleXrPicture told;
    Runtime& runtime = Runtime::get();
    const std::lock_guard lock(runtime.mutex);
    runtime.isPictureWanted = true;
    if (!runtime.picture)
        return nullptr;
    shown = *std::exchange(runtime.picture, std::nullopt);
    told = {shown.width, shown.height, shown.rgba.data()};
    return &told;
}

__attribute__((visibility("default"))) const char* fettle_xr_report()
{
    Runtime& runtime = Runtime::get();
    const std::lock_guard lock(runtime.mutex);
    return kept(runtime.report().dump());
}
}
