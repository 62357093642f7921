#include "vr/simulator/calls.h"
#include "vr/simulator/system.h"

namespace simulator
{
namespace
{
std::shared_ptr<ShareContext> shareWith(const GlClient& client)
{
    try {
        return std::make_shared<ShareContext>(client);
    } catch (const std::runtime_error&) {
        throw CallFailure{XR_ERROR_GRAPHICS_DEVICE_INVALID, "no OpenGL context can be shared with the binding's"};
    }
}
} // namespace

XrResult createSession(Call& call, XrInstance handle, const XrSessionCreateInfo* info, XrSession* out)
{
    Instance& instance = call.get<Instance>(handle);
    Runtime& runtime = call.runtime;
    validated(info, XR_TYPE_SESSION_CREATE_INFO);
    validated(out);
    require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "there are no flags");
    requireSystem(info->systemId);
    const auto client = glClientIn(info->next);
    require(instance.extensions.contains(XR_KHR_OPENGL_ENABLE_EXTENSION_NAME) && client,
            XR_ERROR_GRAPHICS_DEVICE_INVALID, "no OpenGL binding for this system");
    require(instance.requirementsAsked, XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
            "xrGetOpenGLGraphicsRequirementsKHR was not called");
    require(!runtime.session, XR_ERROR_LIMIT_REACHED, "one session at a time");
    auto session = std::make_shared<Session>(runtime, shareWith(*client));
    *out = runtime.handles.add<XrSession>(session, &instance);
    runtime.session = session;
    call.checkContext(*session);
    session->open();
    return XR_SUCCESS;
}

XrResult destroySession(Call& call, XrSession handle)
{
    Runtime& runtime = call.runtime;
    const auto session = runtime.handles.find<Session>(handle);
    call.checkContext(*session);
    session->instance().events.drop(handle);
    runtime.session.reset();
    runtime.handles.destroy(*session);
    runtime.log.flush();
    runtime.changed.notify_all();
    return XR_SUCCESS;
}

XrResult beginSession(Call& call, XrSession handle, const XrSessionBeginInfo* info)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_SESSION_BEGIN_INFO);
    require(!session.isRunning(), XR_ERROR_SESSION_RUNNING, "it runs already");
    requireViews(call.runtime.world, info->primaryViewConfigurationType);
    require(session.state() == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY, "the session is not ready");
    session.begin(info->primaryViewConfigurationType);
    return XR_SUCCESS;
}

XrResult endSession(Call& call, XrSession handle)
{
    Session& session = call.get<Session>(handle);
    requireRunning(session);
    require(session.state() == XR_SESSION_STATE_STOPPING, XR_ERROR_SESSION_NOT_STOPPING, "the session is not stopping");
    if (session.begun)
        call.error("a frame that was begun is not ended");
    session.end();
    call.runtime.changed.notify_all();
    return XR_SUCCESS;
}

XrResult requestExitSession(Call& call, XrSession handle)
{
    Session& session = call.get<Session>(handle);
    requireRunning(session);
    session.requestExit();
    return XR_SUCCESS;
}
} // namespace simulator
