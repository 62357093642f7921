#pragma once

#include <memory>

namespace vr
{
/// How OpenXR is told of the OpenGL context that is current. One file per platform makes it.
class GlBinding
{
public:
    virtual ~GlBinding() = default;

    /// The extension that it needs.
    virtual const char* extension() const = 0;
    /// For XrSessionCreateInfo::next; lives as long as this, and is good as long as the context is.
    virtual const void* next() const = 0;
};

/// Of the context that is current on this thread; null where none is, or where it is of a kind that OpenXR has no word
/// for.
std::unique_ptr<GlBinding> currentGlBinding();

/// The same for EGL alone, as under Wayland.
std::unique_ptr<GlBinding> currentEglBinding();
} // namespace vr
