#include "vr/openxr/xr_instance.h"

#include <algorithm>

namespace vr
{
namespace
{
/// Locked by the existing instance: the loader allows only one at a time.
std::mutex onlyInstance;

/// OpenXR versions to ask for until the runtime accepts one. The first is the one that this client is written and
/// tested for; the headers' own version may be 1.1, which a runtime of OpenXR 1.0 refuses.
constexpr XrVersion requestedVersions[] = {XR_MAKE_VERSION(1, 0, 20), XR_MAKE_VERSION(1, 1, 0)};

/// Extension for drawing with OpenGL. An EGL context needs XR_MNDX_egl_enable too.
constexpr const char* openGlExtension = "XR_KHR_opengl_enable";
constexpr const char* wantedExtensions[] = {openGlExtension,
                                            "XR_MNDX_egl_enable",
                                            XR_KHR_VISIBILITY_MASK_EXTENSION_NAME,
                                            XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME,
                                            XR_FB_DISPLAY_REFRESH_RATE_EXTENSION_NAME,
                                            XR_EXT_HAND_TRACKING_EXTENSION_NAME,
                                            localFloorExtension};

template <std::size_t N> QString textOf(const char (&name)[N])
{
    return QString::fromUtf8(name, static_cast<qsizetype>(strnlen(name, N)));
}

/// Returns all extensions that are used if the runtime has them, some of them more than once.
std::vector<const char*> allWantedExtensions()
{
    std::vector<const char*> wanted(std::begin(wantedExtensions), std::end(wantedExtensions));
    for (const WandProfile& profile : wandProfiles())
        if (profile.extension)
            wanted.push_back(profile.extension);
    return wanted;
}

bool contains(const std::vector<const char*>& extensions, const char* name)
{
    return std::ranges::any_of(extensions, [&](const char* one) { return std::strcmp(one, name) == 0; });
}

std::vector<const char*> offeredExtensions()
{
    const auto offered = enumerate("xrEnumerateInstanceExtensionProperties",
                                   XrExtensionProperties{XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0},
                                   [](auto capacity, auto* count, auto* items) {
                                       return xrEnumerateInstanceExtensionProperties(nullptr, capacity, count, items);
                                   });
    std::vector<const char*> found;
    for (const char* wanted : allWantedExtensions())
        if (!contains(found, wanted) && std::any_of(offered.begin(), offered.end(), [&](const auto& one) {
                return std::strcmp(one.extensionName, wanted) == 0;
            }))
            found.push_back(wanted);
    return found;
}

XrResult tryInstance(const std::vector<const char*>& extensions, XrVersion version, XrInstance& made)
{
    XrInstanceCreateInfo info{};
    info.type = XR_TYPE_INSTANCE_CREATE_INFO;
    std::strncpy(info.applicationInfo.applicationName, "Fettle", XR_MAX_APPLICATION_NAME_SIZE - 1);
    info.applicationInfo.applicationVersion = 1;
    info.applicationInfo.apiVersion = version;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.enabledExtensionNames = extensions.data();
    return xrCreateInstance(&info, &made);
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
    XrResult result = XR_ERROR_API_VERSION_UNSUPPORTED;
    for (const XrVersion version : requestedVersions) {
        if (result != XR_ERROR_API_VERSION_UNSUPPORTED)
            break;
        XrInstance made = XR_NULL_HANDLE;
        result = tryInstance(m_extensions, version, made);
        m_version = version;
        m_handle = InstanceHandle(made);
    }
    check(result, "xrCreateInstance");
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
    return contains(m_extensions, extension);
}

bool Instance::knows(const WandProfile& profile) const
{
    return profile.isInCore(m_version) || (profile.extension && has(profile.extension));
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
