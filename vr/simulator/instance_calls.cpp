#include "vr/simulator/actions.h"
#include "vr/simulator/calls.h"
#include "vr/simulator/enum_names.h"
#include "vr/simulator/system.h"

namespace simulator
{
namespace
{
struct Extension
{
    std::string_view name;
    std::uint32_t version;
};

constexpr Extension openGl{XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_KHR_opengl_enable_SPEC_VERSION};
constexpr Extension others[] = {
    {XR_KHR_VISIBILITY_MASK_EXTENSION_NAME, XR_KHR_visibility_mask_SPEC_VERSION},
    {XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME, XR_KHR_composition_layer_depth_SPEC_VERSION},
    {XR_FB_DISPLAY_REFRESH_RATE_EXTENSION_NAME, XR_FB_display_refresh_rate_SPEC_VERSION},
    {XR_EXT_HAND_TRACKING_EXTENSION_NAME, XR_EXT_hand_tracking_SPEC_VERSION},
};

/// Adds the extensions that define interaction profiles, each once.
void addProfileExtensions(std::vector<Extension>& offered)
{
    for (const Profile& profile : profiles()) {
        const bool isNew =
            std::ranges::none_of(offered, [&](const Extension& it) { return it.name == profile.extension; });
        if (!profile.extension.empty() && isNew)
            offered.push_back({profile.extension, 1});
    }
}

std::vector<Extension> offeredExtensions(const SimulatedWorld& world)
{
    std::vector<Extension> offered;
    if (world.hasOpenGl)
        offered.push_back(openGl);
    if (world.hasExtensions) {
        offered.insert(offered.end(), std::begin(others), std::end(others));
        addProfileExtensions(offered);
    }
    if (world.hasLocalFloor)
        offered.push_back({localFloorExtension, 1});
    std::erase_if(offered, [&](const Extension& it) { return world.withheld.contains(it.name); });
    return offered;
}

void checkExtensions(const XrInstanceCreateInfo& info, const SimulatedWorld& world)
{
    const std::vector<Extension> offered = offeredExtensions(world);
    for (std::uint32_t i = 0; i < info.enabledExtensionCount; ++i) {
        const char* name = (&validated(info.enabledExtensionNames))[i];
        validated(name);
        const bool isOffered = std::ranges::any_of(offered, [name](const Extension& one) { return one.name == name; });
        require(isOffered, XR_ERROR_EXTENSION_NOT_PRESENT, "an extension is not offered");
    }
}

void copyName(char* to, const std::string& name, std::size_t size)
{
    const std::size_t length = name.copy(&validated(to), size - 1);
    to[length] = 0;
}
} // namespace

std::optional<XrEventDataBuffer> Events::take()
{
    if (m_waiting.empty())
        return {};
    const XrEventDataBuffer first = m_waiting.front();
    m_waiting.pop_front();
    return first;
}

void Events::lose()
{
    const auto lost = static_cast<std::uint32_t>(std::erase_if(m_waiting, [](const XrEventDataBuffer& event) {
        return event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
    }));
    push(XrEventDataEventsLost{XR_TYPE_EVENT_DATA_EVENTS_LOST, nullptr, lost});
}

void Events::drop(XrSession session)
{
    std::erase_if(m_waiting, [session](const XrEventDataBuffer& event) {
        return event.type != XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING && event.type != XR_TYPE_EVENT_DATA_EVENTS_LOST &&
               reinterpret_cast<const XrEventDataSessionStateChanged&>(event).session == session;
    });
}

XrResult enumerateInstanceExtensionProperties(Call& call, const char* layer, std::uint32_t capacity,
                                              std::uint32_t* count, XrExtensionProperties* properties)
{
    require(!layer, XR_ERROR_API_LAYER_NOT_PRESENT, "the runtime has no layers");
    writeItems(OutputArray<XrExtensionProperties>{capacity, count, properties}, offeredExtensions(call.runtime.world),
               [](XrExtensionProperties& to, const Extension& from) {
                   validated(&to, XR_TYPE_EXTENSION_PROPERTIES);
                   copyText(to.extensionName, from.name);
                   to.extensionVersion = from.version;
               });
    return XR_SUCCESS;
}

XrResult createInstance(Call& call, const XrInstanceCreateInfo* info, XrInstance* instance)
{
    validated(info, XR_TYPE_INSTANCE_CREATE_INFO);
    validated(instance);
    Runtime& runtime = call.runtime;
    require(runtime.world.hasRuntime, XR_ERROR_RUNTIME_UNAVAILABLE, "so the script says");
    require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "there are no flags");
    require(info->applicationInfo.applicationName[0] != 0, XR_ERROR_NAME_INVALID, "the application has no name");
    const XrVersion version = info->applicationInfo.apiVersion;
    const bool isKnown = XR_VERSION_MAJOR(version) == 1 && runtime.world.minors.contains(XR_VERSION_MINOR(version));
    require(isKnown, XR_ERROR_API_VERSION_UNSUPPORTED, "not a version of the script");
    checkExtensions(*info, runtime.world);
    require(!runtime.instance, XR_ERROR_LIMIT_REACHED, "one instance at a time");
    runtime.instance = std::make_shared<Instance>();
    runtime.instance->apiVersion = version;
    for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i)
        runtime.instance->extensions.insert(info->enabledExtensionNames[i]);
    *instance = runtime.handles.add<XrInstance>(runtime.instance, nullptr);
    return XR_SUCCESS;
}

XrResult destroyInstance(Call& call, XrInstance handle)
{
    Runtime& runtime = call.runtime;
    const auto instance = runtime.handles.find<Instance>(handle);
    runtime.session.reset();
    runtime.instance.reset();
    runtime.handles.destroy(*instance);
    runtime.log.flush();
    runtime.changed.notify_all();
    return XR_SUCCESS;
}

XrResult getInstanceProperties(Call& call, XrInstance handle, XrInstanceProperties* properties)
{
    call.get<Instance>(handle);
    validated(properties, XR_TYPE_INSTANCE_PROPERTIES);
    properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
    copyText(properties->runtimeName, "Fettle's simulator");
    return XR_SUCCESS;
}

XrResult pollEvent(Call& call, XrInstance handle, XrEventDataBuffer* buffer)
{
    Instance& instance = call.get<Instance>(handle);
    validated(buffer, XR_TYPE_EVENT_DATA_BUFFER);
    const auto event = instance.events.take();
    if (!event)
        return XR_EVENT_UNAVAILABLE;
    *buffer = *event;
    call.line["event"] = nameOf(event->type);
    if (event->type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED)
        call.line["state"] = nameOf(reinterpret_cast<const XrEventDataSessionStateChanged&>(*event).state);
    return XR_SUCCESS;
}

XrResult resultToString(Call& call, XrInstance handle, XrResult result, char* buffer)
{
    call.get<Instance>(handle);
    copyName(buffer, nameOf(result), XR_MAX_RESULT_STRING_SIZE);
    return XR_SUCCESS;
}

XrResult structureTypeToString(Call& call, XrInstance handle, XrStructureType type, char* buffer)
{
    call.get<Instance>(handle);
    copyName(buffer, nameOf(type), XR_MAX_STRUCTURE_NAME_SIZE);
    return XR_SUCCESS;
}

XrResult stringToPath(Call& call, XrInstance handle, const char* text, XrPath* path)
{
    Instance& instance = call.get<Instance>(handle);
    validated(path) = instance.paths.number(&validated(text));
    return XR_SUCCESS;
}

XrResult pathToString(Call& call, XrInstance handle, XrPath path, std::uint32_t capacity, std::uint32_t* count,
                      char* buffer)
{
    writeText({capacity, count, buffer}, call.get<Instance>(handle).paths.text(path));
    return XR_SUCCESS;
}
} // namespace simulator
