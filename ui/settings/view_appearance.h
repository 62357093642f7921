#pragma once

#include <array>

namespace ui
{
/// What the clay seems to be made of. Paint shows the colours of the vertices as they are, the others under their own.
enum class Material { Clay, Grey, Wax, Porcelain, Pearl, Skin, Paint };

/// What stands behind the model. Theme is light or dark as the window is.
enum class Background { Theme, Light, Dark, Sky, White, Black };

template <class T> struct Named
{
    T value;
    const char* key; ///< in settings, and behind the dot in an action's id
};

inline constexpr std::array<Named<Material>, 7> materials{{{Material::Clay, "clay"},
                                                           {Material::Grey, "grey"},
                                                           {Material::Wax, "wax"},
                                                           {Material::Porcelain, "porcelain"},
                                                           {Material::Pearl, "pearl"},
                                                           {Material::Skin, "skin"},
                                                           {Material::Paint, "paint"}}};

inline constexpr std::array<Named<Background>, 6> backgrounds{{{Background::Theme, "theme"},
                                                               {Background::Light, "light"},
                                                               {Background::Dark, "dark"},
                                                               {Background::Sky, "sky"},
                                                               {Background::White, "white"},
                                                               {Background::Black, "black"}}};

/// How the view shows the model; not saved with the model.
struct ViewAppearance
{
    Material material = Material::Clay;
    Background background = Background::Theme;
    bool wireframe = false;
    bool flat = false; ///< each triangle in one shade
    bool ground = true;
    bool scaleBar = true;
    bool navigationCube = true;
    bool caption = true; ///< of the brush, while VR is worn
    bool tint = true;    ///< colours what the brush would move
    bool cavity = false; ///< darkens valleys, lightens ridges
    bool symmetryPlane = true;

    bool operator==(const ViewAppearance&) const = default;
};
} // namespace ui
