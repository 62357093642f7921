#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Parameters of the clay's shading (uniforms of clay.frag), the same for desktop and headset. Colours are linear.
struct Shading
{
    /// Factor on the vertex's colour; an unpainted model is grey 200 in sRGB, 0.58 linear
    Vec3f tint = Vec3f::Zero();
    float wrap = 0.18F;            ///< how far light reaches past the edge of the shadow, 0 to 1
    float gloss = 0.11F;           ///< strength of the highlight, 0 to 1
    float sharpness = 36;          ///< exponent of the highlight
    float rim = 0.16F;             ///< brightness of the rim, seen at grazing angles
    Vec3f through = Vec3f::Zero(); ///< colour added along the edge of the shadow, as of light shining through
    Vec3f sheen = Vec3f::Zero();   ///< colour added where the surface turns away from the viewer

    bool operator==(const Shading&) const = default;
};
} // namespace core
