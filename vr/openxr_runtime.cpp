#include "openxr_runtime.h"

#include <openxr/openxr.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace vr
{
namespace
{
constexpr const char* openGlExtension = "XR_KHR_opengl_enable";

struct Instance
{
    XrInstance handle = XR_NULL_HANDLE;
    Instance() = default;
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;
    ~Instance()
    {
        if (handle != XR_NULL_HANDLE)
            xrDestroyInstance(handle);
    }
};

template <std::size_t N> QString text(const char (&name)[N])
{
    return QString::fromUtf8(name, static_cast<qsizetype>(strnlen(name, N)));
}

/// The result's name, without an instance to ask.
QString resultName(XrResult result)
{
    switch (result) {
    case XR_ERROR_RUNTIME_UNAVAILABLE: return QStringLiteral("XR_ERROR_RUNTIME_UNAVAILABLE");
    case XR_ERROR_RUNTIME_FAILURE: return QStringLiteral("XR_ERROR_RUNTIME_FAILURE");
    case XR_ERROR_INITIALIZATION_FAILED: return QStringLiteral("XR_ERROR_INITIALIZATION_FAILED");
    case XR_ERROR_INSTANCE_LOST: return QStringLiteral("XR_ERROR_INSTANCE_LOST");
    case XR_ERROR_API_VERSION_UNSUPPORTED: return QStringLiteral("XR_ERROR_API_VERSION_UNSUPPORTED");
    case XR_ERROR_LIMIT_REACHED: return QStringLiteral("XR_ERROR_LIMIT_REACHED");
    case XR_ERROR_FILE_ACCESS_ERROR: return QStringLiteral("XR_ERROR_FILE_ACCESS_ERROR");
    case XR_ERROR_FILE_CONTENTS_INVALID: return QStringLiteral("XR_ERROR_FILE_CONTENTS_INVALID");
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE: return QStringLiteral("XR_ERROR_FORM_FACTOR_UNAVAILABLE");
    case XR_ERROR_FORM_FACTOR_UNSUPPORTED: return QStringLiteral("XR_ERROR_FORM_FACTOR_UNSUPPORTED");
    default: return QStringLiteral("XrResult %1").arg(static_cast<int>(result));
    }
}

XrResult findOpenGl(bool& found)
{
    std::uint32_t count = 0;
    if (const XrResult result = xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr); XR_FAILED(result))
        return result;
    std::vector<XrExtensionProperties> extensions(count, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
    const XrResult result = xrEnumerateInstanceExtensionProperties(nullptr, count, &count, extensions.data());
    found = std::any_of(extensions.begin(), extensions.end(),
                        [](const auto& extension) { return std::strcmp(extension.extensionName, openGlExtension) == 0; });
    return result;
}

XrResult createInstance(Instance& instance)
{
    XrInstanceCreateInfo info{};
    info.type = XR_TYPE_INSTANCE_CREATE_INFO;
    std::strncpy(info.applicationInfo.applicationName, "Fettle", XR_MAX_APPLICATION_NAME_SIZE - 1);
    info.applicationInfo.applicationVersion = 1;
    info.applicationInfo.apiVersion = XR_CURRENT_API_VERSION;
    return xrCreateInstance(&info, &instance.handle);
}

QString runtimeName(const Instance& instance)
{
    XrInstanceProperties properties{};
    properties.type = XR_TYPE_INSTANCE_PROPERTIES;
    if (XR_FAILED(xrGetInstanceProperties(instance.handle, &properties)))
        return {};
    return QStringLiteral("%1 %2.%3.%4")
        .arg(text(properties.runtimeName))
        .arg(XR_VERSION_MAJOR(properties.runtimeVersion))
        .arg(XR_VERSION_MINOR(properties.runtimeVersion))
        .arg(XR_VERSION_PATCH(properties.runtimeVersion));
}

XrResult findHeadset(const Instance& instance, QString& name)
{
    XrSystemGetInfo info{};
    info.type = XR_TYPE_SYSTEM_GET_INFO;
    info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    XrSystemId system = XR_NULL_SYSTEM_ID;
    XrResult result = xrGetSystem(instance.handle, &info, &system);
    if (XR_FAILED(result))
        return result;
    XrSystemProperties properties{};
    properties.type = XR_TYPE_SYSTEM_PROPERTIES;
    result = xrGetSystemProperties(instance.handle, system, &properties);
    name = text(properties.systemName);
    return result;
}
} // namespace

HeadsetStatus OpenXrRuntime::probe()
{
    HeadsetStatus status;
    bool hasOpenGl = false;
    Instance instance;
    XrResult result = findOpenGl(hasOpenGl);
    if (XR_SUCCEEDED(result))
        result = createInstance(instance);
    if (XR_SUCCEEDED(result)) {
        status.runtime = runtimeName(instance);
        status.state = HeadsetStatus::State::NoHeadset;
        result = findHeadset(instance, status.headset);
        if (XR_SUCCEEDED(result))
            status.state = hasOpenGl ? HeadsetStatus::State::Ready : HeadsetStatus::State::NoOpenGl;
    }
    status.text = textOf(status, resultName(result));
    return status;
}

QString OpenXrRuntime::textOf(const HeadsetStatus& status, const QString& reason)
{
    switch (status.state) {
    case HeadsetStatus::State::NoRuntime:
        //: %1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE
        return tr("No OpenXR runtime answers (%1). Start SteamVR, Monado or the headset's own program, then ask again.")
            .arg(reason);
    case HeadsetStatus::State::NoHeadset:
        return tr("%1 is running, but no headset is ready (%2). Plug it in and switch it on, then ask again.")
            .arg(status.runtime, reason);
    case HeadsetStatus::State::NoOpenGl:
        return tr("%1 shows %2, but takes no OpenGL pictures.").arg(status.runtime, status.headset);
    case HeadsetStatus::State::Ready:
        return tr("%1 is ready, through %2.").arg(status.headset, status.runtime);
    }
    return {};
}
} // namespace vr
