#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// What viewers make of the clay, on the desktop and in the headset: the numbers that clay.frag takes. Colours are
/// linear light.
struct Shading
{
    Vec3f tint = Vec3f::Zero();    ///< times the vertex's colour; a model that nobody painted is grey 200, linear 0.58
    float wrap = 0.18F;            ///< how far the light creeps past the edge of the shadow, 0 to 1
    float gloss = 0.11F;           ///< strength of the highlight
    float sharpness = 36;          ///< of the highlight, an exponent
    float rim = 0.16F;             ///< brightness of what is seen at a grazing angle
    Vec3f through = Vec3f::Zero(); ///< what shines out of the shadow's edge
    Vec3f sheen = Vec3f::Zero();   ///< what is added where the surface turns away

    bool operator==(const Shading&) const = default;
};
} // namespace core
