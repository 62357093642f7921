#pragma once

#include <openxr/openxr.h>

#include <span>

namespace vr
{
/// The way in which the runtime combines a picture with the real room.
struct Blending
{
    XrEnvironmentBlendMode mode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    /// The real room is seen wherever the picture has the alpha value 0, or wherever it is black if light is added.
    bool hasPassthrough = false;

    friend bool operator==(const Blending&, const Blending&) = default;
};

/// Returns the way that shows or hides the real room, as far as the offered modes can. Glasses that only add light
/// cannot hide it. A mode that blends by alpha hides it behind a picture that is opaque everywhere.
Blending blendingOf(std::span<const XrEnvironmentBlendMode> offered, bool wantsPassthrough);

/// Returns whether the offered modes can show the real room.
bool offersPassthrough(std::span<const XrEnvironmentBlendMode> offered);
} // namespace vr
