#include "vr/openxr/xr_blending.h"

#include <algorithm>

namespace vr
{
namespace
{
bool contains(std::span<const XrEnvironmentBlendMode> offered, XrEnvironmentBlendMode mode)
{
    return std::ranges::find(offered, mode) != offered.end();
}
} // namespace

Blending blendingOf(std::span<const XrEnvironmentBlendMode> offered, bool wantsPassthrough)
{
    const bool hasOpaque = contains(offered, XR_ENVIRONMENT_BLEND_MODE_OPAQUE),
               hasAlpha = contains(offered, XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND),
               hasAdditive = contains(offered, XR_ENVIRONMENT_BLEND_MODE_ADDITIVE);
    if (!wantsPassthrough && hasOpaque)
        return {XR_ENVIRONMENT_BLEND_MODE_OPAQUE, false};
    if (hasAlpha)
        return {XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND, wantsPassthrough};
    if (hasAdditive)
        return {XR_ENVIRONMENT_BLEND_MODE_ADDITIVE, true};
    return {hasOpaque || offered.empty() ? XR_ENVIRONMENT_BLEND_MODE_OPAQUE : offered.front(), false};
}

bool offersPassthrough(std::span<const XrEnvironmentBlendMode> offered)
{
    return blendingOf(offered, true).hasPassthrough;
}
} // namespace vr
