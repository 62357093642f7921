#pragma once

#include "ui/settings/view_appearance.h"

#include "core/render/shading.h"

#include <QColor>

namespace ui
{
/// Returns the shading parameters of a material.
core::Shading shadingOf(Material material);

/// The background behind the model: colours at top and bottom, sRGB.
struct Backdrop
{
    QColor top, bottom;
    float glow = 0.035F; ///< strength of the light spot behind the model, 0 to 1
};

Backdrop backdropOf(Background background, bool darkTheme);
/// Returns true if lines on the backdrop must be light to be visible.
bool isDark(const Backdrop& backdrop);
} // namespace ui
