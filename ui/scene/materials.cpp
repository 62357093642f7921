#include "ui/scene/materials.h"

namespace ui
{
core::Shading shadingOf(Material material)
{
    switch (material) {
    case Material::Clay: // makes an unpainted model sRGB 194, 150, 126
        return {.tint = {0.93F, 0.527F, 0.361F}};
    case Material::Grey:
        return {.tint = {0.62F, 0.63F, 0.66F}, .wrap = 0.10F, .gloss = 0.16F, .sharpness = 22};
    case Material::Wax:
        return {.tint = {0.80F, 0.10F, 0.07F},
                .wrap = 0.42F,
                .gloss = 0.34F,
                .sharpness = 48,
                .rim = 0.22F,
                .through = {0.16F, 0.012F, 0.004F}};
    case Material::Porcelain:
        return {.tint = {1.18F, 1.20F, 1.24F},
                .wrap = 0.30F,
                .gloss = 0.75F,
                .sharpness = 180,
                .rim = 0.30F,
                .through = {0.03F, 0.035F, 0.05F}};
    case Material::Pearl:
        return {.tint = {0.98F, 0.93F, 0.90F},
                .wrap = 0.24F,
                .gloss = 0.30F,
                .sharpness = 14,
                .rim = 0.30F,
                .sheen = {0.20F, 0.05F, 0.26F}};
    case Material::Skin:
        return {.tint = {1.22F, 0.82F, 0.64F},
                .wrap = 0.45F,
                .gloss = 0.13F,
                .sharpness = 18,
                .rim = 0.20F,
                .through = {0.15F, 0.030F, 0.016F}};
    case Material::Paint:
        return {.tint = {1, 1, 1}, .wrap = 0.30F, .gloss = 0.04F, .sharpness = 24, .rim = 0.06F};
    }
    return {};
}

Backdrop backdropOf(Background background, bool darkTheme)
{
    const Backdrop light{{222, 225, 229}, {176, 182, 189}}, dark{{70, 74, 80}, {34, 36, 40}};
    const Backdrop backdrops[] = {
        darkTheme ? dark : light, light, dark, {{118, 160, 202}, {222, 230, 236}}, {Qt::white, Qt::white, 0},
        {Qt::black, Qt::black, 0}};
    static_assert(std::size(backdrops) == static_cast<std::size_t>(Background::Black) + 1);
    return backdrops[static_cast<std::size_t>(background)];
}

bool isDark(const Backdrop& backdrop)
{
    return backdrop.top.lightness() + backdrop.bottom.lightness() < 255;
}
} // namespace ui
