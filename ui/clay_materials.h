#pragma once

#include "view_look.h"

#include <QColor>
#include <QVector3D>

namespace ui
{
/// The numbers behind a material, as clay.frag takes them. Colours are linear.
struct Shading
{
    QVector3D tint{};     ///< times the vertex's colour; a model that nobody painted is grey 200, linear 0.58
    float wrap = 0.18F;   ///< how far the light creeps past the edge of the shadow, 0 to 1
    float gloss = 0.11F;  ///< strength of the highlight
    float sharpness = 36; ///< of the highlight, an exponent
    float rim = 0.16F;    ///< brightness of what is seen at a grazing angle
    QVector3D through{};  ///< what shines out of the shadow's edge
    QVector3D sheen{};    ///< what is added where the surface turns away
};

Shading shadingOf(Material material);

/// The two colours behind the model, sRGB.
struct Backdrop
{
    QColor top, bottom;
    float glow = 0.035F; ///< behind the model
};

Backdrop backdropOf(Background background, bool darkTheme);
/// Whether what is drawn on it must be light.
bool isDark(const Backdrop& backdrop);
} // namespace ui
