#include "vr/simulator/runtime.h"

#include "vr/simulator/enum_names.h"
#include "vr/simulator/session.h"
#include "vr/simulator/system.h"
#include "vr/simulator/xr_pose.h"

#include <cstdlib>
#include <sstream>

namespace simulator
{
namespace
{
std::string contents(const char* path)
{
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error(std::string("cannot read ") + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}
} // namespace

Runtime& Runtime::get()
{
    // Never deleted: at the end of the process the client's display, which it uses, may be gone.
    static Runtime& runtime = *new Runtime;
    return runtime;
}

void Runtime::load(const std::string& text)
{
    if (instance)
        throw std::runtime_error("an instance is in use");
    script = Script::parse(text);
    world = {};
    framesAllowed = 0;
    sessionsMade = 0;
    picture.reset();
    log.open(std::getenv("FETTLE_XR_LOG"));
    const char* folder = std::getenv("FETTLE_XR_FRAMES");
    pictureFolder = folder ? folder : "";
    m_isLoaded = true;
    apply(script.start());
}

void Runtime::loadOnce()
{
    if (m_isLoaded)
        return;
    const char* path = std::getenv("FETTLE_XR_SCRIPT");
    load(path && *path ? contents(path) : "{}");
}

void Runtime::apply(const ScriptStep& step)
{
    const XrTime start = world.next();
    for (const Change& change : step)
        change(*this, start);
    if (session)
        session->updateState();
    changed.notify_all();
}

std::int64_t Runtime::nextFrame() const
{
    return session ? session->nextFrame : 0;
}

void Runtime::recentre(const Recentring& recentring)
{
    const bool isStage = recentring.space == XR_REFERENCE_SPACE_TYPE_STAGE;
    Motion& origin = isStage ? world.stage : world.local;
    const XrTime time = world.next() + recentring.after * world.period();
    const vr::Pose inPrevious = origin.at(time).inverse() * recentring.origin;
    origin.position.moveTo(recentring.origin.position, time, 0);
    origin.rotation.moveTo(recentring.origin.rotation, time, 0);
    if (!session)
        return;
    instance->events.push(XrEventDataReferenceSpaceChangePending{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING,
                                                                 nullptr, session->handle(), recentring.space, time,
                                                                 XR_TRUE, toXr(inPrevious)});
}

void Runtime::hide(double share)
{
    world.headset.hiddenShare = share;
    if (!session || !instance->extensions.contains(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME))
        return;
    for (std::uint32_t view = 0; view < viewCount(session->views()); ++view)
        instance->events.push(XrEventDataVisibilityMaskChangedKHR{XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR,
                                                                  nullptr, session->handle(), session->views(), view});
}

void Runtime::loseSession(std::int64_t afterFrames)
{
    if (!session)
        return;
    session->announceLoss();
    session->lostAt = nextFrame() + afterFrames;
    loseIfDue();
}

void Runtime::loseInstance(std::int64_t afterFrames)
{
    if (!instance)
        return;
    const XrTime time = world.next() + afterFrames * world.period();
    instance->events.push(XrEventDataInstanceLossPending{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr, time});
    instance->lostAt = nextFrame() + afterFrames;
    loseIfDue();
}

void Runtime::loseIfDue()
{
    if (session && session->lostAt && nextFrame() >= *session->lostAt)
        session->lost = XR_ERROR_SESSION_LOST;
    if (instance && instance->lostAt && nextFrame() >= *instance->lostAt)
        instance->lost = XR_ERROR_INSTANCE_LOST;
}

void Runtime::exitSession()
{
    if (session)
        session->requestExit();
}

nlohmann::json Runtime::report() const
{
    nlohmann::json report = log.report();
    report["state"] = session ? nameOf(session->state()) : "";
    report["is_running"] = session && session->isRunning();
    report["is_frozen"] = isClientFrozen;
    report["api_minor"] = instance ? nlohmann::json(XR_VERSION_MINOR(instance->apiVersion)) : nlohmann::json();
    report["sessions"] = sessionsMade;
    report["frames_ended"] = framesEnded;
    return report;
}
} // namespace simulator
