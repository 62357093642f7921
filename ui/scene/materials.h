#pragma once

#include "ui/settings/view_appearance.h"

#include "core/render/shading.h"

#include <QColor>

namespace ui
{
/// The numbers behind a material.
core::Shading shadingOf(Material material);

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
