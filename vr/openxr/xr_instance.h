#pragma once

#include "vr/openxr/openxr_runtime.h"
#include "vr/openxr/xr_handle.h"
#include "vr/openxr/xr_result.h"

#include <cstring>
#include <mutex>
#include <optional>
#include <string>

namespace vr
{
/// Headers may be too old for it.
inline constexpr const char* localFloorExtension = "XR_EXT_local_floor";

/// What the runtime has to tell.
class XrEvent
{
public:
    explicit XrEvent(const XrEventDataBuffer& data) : m_data(data) {}

    XrStructureType type() const { return m_data.type; }
    /// The type has been asked about.
    template <class Event> Event as() const
    {
        Event event{};
        std::memcpy(static_cast<void*>(&event), &m_data, sizeof(Event));
        return event;
    }

private:
    XrEventDataBuffer m_data;
};

/// The loader's one instance, and the headset that it knows. Making one may take as long as a runtime takes to start,
/// up to seconds. To be used, and destroyed, on the thread that made it.
class Instance
{
public:
    /// Waits while there is another in this process. An absent runtime or headset is an answer: see status().
    Instance();
    /// Without waiting: where there is another, the answer is InUse.
    explicit Instance(std::try_to_lock_t);

    /// Without its text. From here on all may be used only where it is Ready.
    const HeadsetStatus& status() const { return m_status; }

    XrInstance handle() const { return m_handle.get(); }
    XrSystemId system() const { return m_system; }
    /// Whether it was offered and is enabled.
    bool has(const char* extension) const;

    /// Throw XrError.
    XrPath path(const char* text) const;
    std::string text(XrPath path) const;
    std::optional<XrEvent> nextEvent() const;
    template <class Function> Function function(const char* name) const
    {
        PFN_xrVoidFunction found = nullptr;
        check(xrGetInstanceProcAddr(handle(), name, &found), name);
        return reinterpret_cast<Function>(found);
    }

private:
    explicit Instance(std::unique_lock<std::mutex> lock);
    void create();
    void findHeadset();

    std::unique_lock<std::mutex> m_lock;
    HeadsetStatus m_status;
    std::vector<const char*> m_extensions;
    InstanceHandle m_handle;
    XrSystemId m_system = XR_NULL_SYSTEM_ID;
};
} // namespace vr
