#include "vr/openxr/xr_instance.h"

#include <algorithm>

namespace vr
{
namespace
{
/// Locked by the existing instance: the loader allows only one at a time.
std::mutex onlyInstance;

/// OpenXR version that this client is written and tested for. The headers' own version may be 1.1, which a runtime of
/// OpenXR 1.0 refuses.
constexpr XrVersion requestedVersion = XR_MAKE_VERSION(1, 0, 20);

/// Extension for drawing with OpenGL. An EGL context needs XR_MNDX_egl_enable too.
constexpr const char* openGlExtension = "XR_KHR_opengl_enable";
constexpr const char* wantedExtensions[] = {openGlExtension,
                                            "XR_MNDX_egl_enable",
                                            XR_KHR_VISIBILITY_MASK_EXTENSION_NAME,
                                            XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME,
                                            XR_FB_DISPLAY_REFRESH_RATE_EXTENSION_NAME,
                                            localFloorExtension};

template <std::size_t N> QString textOf(const char (&name)[N])
{
    return QString::fromUtf8(name, static_cast<qsizetype>(strnlen(name, N)));
}

std::vector<const char*> offeredExtensions()
{
    const auto offered = enumerate("xrEnumerateInstanceExtensionProperties",
                                   XrExtensionProperties{XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0},
                                   [](auto capacity, auto* count, auto* items) {
                                       return xrEnumerateInstanceExtensionProperties(nullptr, capacity, count, items);
                                   });
    std::vector<const char*> found;
    for (const char* wanted : wantedExtensions)
        if (std::any_of(offered.begin(), offered.end(),
                        [&](const auto& one) { return std::strcmp(one.extensionName, wanted) == 0; }))
            found.push_back(wanted);
    return found;
}

InstanceHandle makeInstance(const std::vector<const char*>& extensions)
{
    XrInstanceCreateInfo info{};
    info.type = XR_TYPE_INSTANCE_CREATE_INFO;
    std::strncpy(info.applicationInfo.applicationName, "Fettle", XR_MAX_APPLICATION_NAME_SIZE - 1);
    info.applicationInfo.applicationVersion = 1;
    info.applicationInfo.apiVersion = requestedVersion;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.enabledExtensionNames = extensions.data();
    XrInstance made = XR_NULL_HANDLE;
    check(xrCreateInstance(&info, &made), "xrCreateInstance");
    return InstanceHandle(made);
}

QString runtimeName(XrInstance instance)
{
    XrInstanceProperties properties{};
    properties.type = XR_TYPE_INSTANCE_PROPERTIES;
    check(xrGetInstanceProperties(instance, &properties), "xrGetInstanceProperties");
    return QStringLiteral("%1 %2.%3.%4")
        .arg(textOf(properties.runtimeName))
        .arg(XR_VERSION_MAJOR(properties.runtimeVersion))
        .arg(XR_VERSION_MINOR(properties.runtimeVersion))
        .arg(XR_VERSION_PATCH(properties.runtimeVersion));
}
} // namespace

Instance::Instance() : Instance(std::unique_lock(onlyInstance)) {}

Instance::Instance(std::try_to_lock_t) : Instance(std::unique_lock(onlyInstance, std::try_to_lock)) {}

Instance::Instance(std::unique_lock<std::mutex> lock) : m_lock(std::move(lock))
{
    if (!m_lock) {
        m_status.state = HeadsetStatus::State::InUse;
        return;
    }
    try {
        create();
        m_status.state = HeadsetStatus::State::NoHeadset;
        findHeadset();
        m_status.state = has(openGlExtension) ? HeadsetStatus::State::Ready : HeadsetStatus::State::NoOpenGl;
    } catch (const XrError& error) {
        m_status.reason = resultName(error.result());
    }
}

void Instance::create()
{
    m_extensions = offeredExtensions();
    m_handle = makeInstance(m_extensions);
    m_status.runtime = runtimeName(handle());
}

void Instance::findHeadset()
{
    XrSystemGetInfo info{};
    info.type = XR_TYPE_SYSTEM_GET_INFO;
    info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    check(xrGetSystem(handle(), &info, &m_system), "xrGetSystem");
    XrSystemProperties properties{};
    properties.type = XR_TYPE_SYSTEM_PROPERTIES;
    check(xrGetSystemProperties(handle(), m_system, &properties), "xrGetSystemProperties");
    m_status.headset = textOf(properties.systemName);
}

bool Instance::has(const char* extension) const
{
    return std::any_of(m_extensions.begin(), m_extensions.end(),
                       [&](const char* one) { return std::strcmp(one, extension) == 0; });
}

XrPath Instance::path(const char* text) const
{
    XrPath path = XR_NULL_PATH;
    check(xrStringToPath(handle(), text, &path), "xrStringToPath");
    return path;
}

std::string Instance::text(XrPath path) const
{
    if (path == XR_NULL_PATH)
        return {};
    const auto letters = enumerate("xrPathToString", char{}, [&](auto capacity, auto* count, auto* items) {
        return xrPathToString(handle(), path, capacity, count, items);
    });
    return std::string(letters.data(), strnlen(letters.data(), letters.size()));
}

std::optional<XrEvent> Instance::nextEvent() const
{
    XrEventDataBuffer data; // 4000 bytes, which the runtime fills: clearing them would be wasted work
    data.type = XR_TYPE_EVENT_DATA_BUFFER;
    data.next = nullptr;
    if (check(xrPollEvent(handle(), &data), "xrPollEvent") == XR_EVENT_UNAVAILABLE)
        return {};
    return XrEvent(data);
}
} // namespace vr
