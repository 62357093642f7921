#pragma once

#include <memory>

namespace vr
{
/// Describes the current OpenGL context to OpenXR. Each platform has an implementation in a file of its own.
class GlBinding
{
public:
    virtual ~GlBinding() = default;

    /// Returns the name of the OpenXR extension that this binding needs.
    virtual const char* extension() const = 0;
    /// Returns the structure for XrSessionCreateInfo::next. It lives as long as this object and is valid as long as the
    /// context.
    virtual const void* next() const = 0;
};

/// Returns a binding for the context that is current on this thread. Returns null if there is none, or if OpenXR cannot
/// describe a context of its kind.
std::unique_ptr<GlBinding> currentGlBinding();

/// Returns a binding for the context that is current on this thread if it is an EGL context, as under Wayland; else
/// null.
std::unique_ptr<GlBinding> currentEglBinding();
} // namespace vr
