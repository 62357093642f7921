#pragma once

#include <openxr/openxr.h>

#include <utility>

namespace vr
{
/// Owns an OpenXR handle. Errors of its destruction are ignored: a runtime that has died may refuse it.
template <class Handle, XrResult(XRAPI_PTR* Destroy)(Handle)> class XrHandle
{
public:
    XrHandle() = default;
    explicit XrHandle(Handle handle) : m_handle(handle) {}
    XrHandle(XrHandle&& other) noexcept : m_handle(std::exchange(other.m_handle, Handle(XR_NULL_HANDLE))) {}
    XrHandle& operator=(XrHandle&& other) noexcept
    {
        std::swap(m_handle, other.m_handle);
        return *this;
    }
    ~XrHandle()
    {
        if (m_handle != XR_NULL_HANDLE)
            Destroy(m_handle);
    }

    Handle get() const { return m_handle; }

private:
    Handle m_handle = XR_NULL_HANDLE;
};

using InstanceHandle = XrHandle<XrInstance, xrDestroyInstance>;
using SessionHandle = XrHandle<XrSession, xrDestroySession>;
using SpaceHandle = XrHandle<XrSpace, xrDestroySpace>;
using SwapchainHandle = XrHandle<XrSwapchain, xrDestroySwapchain>;
using ActionSetHandle = XrHandle<XrActionSet, xrDestroyActionSet>;
using ActionHandle = XrHandle<XrAction, xrDestroyAction>;
} // namespace vr
