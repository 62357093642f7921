#pragma once

#include "vr/openxr/openxr_runtime.h"
#include "vr/openxr/xr_bindings.h"
#include "vr/openxr/xr_handle.h"
#include "vr/openxr/xr_result.h"

#include <cstring>
#include <mutex>
#include <optional>
#include <string>

namespace vr
{
/// Name of an extension that older OpenXR headers do not define.
inline constexpr const char* localFloorExtension = "XR_EXT_local_floor";

/// An event of the runtime.
class XrEvent
{
public:
    explicit XrEvent(const XrEventDataBuffer& data) : m_data(data) {}

    XrStructureType type() const { return m_data.type; }
    /// Returns the event as `Event`. Precondition: type() is the type of `Event`.
    template <class Event> Event as() const
    {
        Event event{};
        std::memcpy(static_cast<void*>(&event), &m_data, sizeof(Event));
        return event;
    }

private:
    XrEventDataBuffer m_data;
};

/// The only instance that the loader allows, and the headset that it found. Thread: used and destroyed on the thread
/// that made it. Cost: up to seconds to construct, because a runtime may have to start.
class Instance
{
public:
    /// Waits until this process has no other instance. A missing runtime or headset is no error: see status().
    Instance();
    /// Creates the instance without waiting. If this process has another, the status is InUse.
    explicit Instance(std::try_to_lock_t);

    /// Returns the status without its text. Precondition of all members below: the status is Ready.
    const HeadsetStatus& status() const { return m_status; }

    XrInstance handle() const { return m_handle.get(); }
    XrSystemId system() const { return m_system; }
    /// Returns whether the runtime offers the extension and it is enabled.
    bool has(const char* extension) const;
    /// Returns the version of OpenXR in use, which the runtime supports at least: 1.0, or 1.1 if it refuses 1.0.
    XrVersion version() const { return m_version; }
    /// Returns whether the runtime knows this kind of wand, so that its bindings may be suggested.
    bool knows(const WandProfile& profile) const;

    // The functions below throw XrError.

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
    XrVersion m_version = 0;
    InstanceHandle m_handle;
    XrSystemId m_system = XR_NULL_SYSTEM_ID;
};
} // namespace vr
