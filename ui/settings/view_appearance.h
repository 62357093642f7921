#pragma once

#include <array>

namespace ui
{
/// Apparent materials of the clay. Paint shows the vertices' own colours unchanged; the other materials tint them.
enum class Material { Clay, Grey, Wax, Porcelain, Pearl, Skin, Paint };

/// Backgrounds behind the model. Theme is light or dark like the window.
enum class Background { Theme, Light, Dark, Sky, White, Black };

template <class T> struct Named
{
    T value;
    const char* key; ///< name in settings, and part of an action's id after the dot
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

/// Appearance of the model in the view; not saved with the model.
struct ViewAppearance
{
    Material material = Material::Clay;
    Background background = Background::Theme;
    bool wireframe = false;
    bool flat = false; ///< shades each triangle uniformly
    bool ground = true;
    bool scaleBar = true;
    bool navigationCube = true;
    bool caption = true; ///< shows the brush's caption while VR is worn
    bool tint = true;    ///< colours the vertices that the brush would move
    bool cavity = false; ///< darkens valleys, lightens ridges
    bool symmetryPlane = true;

    bool operator==(const ViewAppearance&) const = default;
};
} // namespace ui
