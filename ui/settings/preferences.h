#pragma once

#include "ui/settings/shortcut_preset.h"

#include <cmath>

namespace ui
{
enum class ThemeChoice { System, Light, Dark };
/// Of what the desktop has, in percent.
enum class TextSize { Normal = 100, Larger = 125, Large = 150, Largest = 175 };
enum class Language { System, English, German, Chinese };

inline constexpr std::array<Named<ThemeChoice>, 3> themeChoices{
    {{ThemeChoice::System, "system"}, {ThemeChoice::Light, "light"}, {ThemeChoice::Dark, "dark"}}};

inline double factorOf(TextSize size)
{
    return static_cast<int>(size) / 100.0;
}

inline constexpr std::array<Named<TextSize>, 4> textSizes{
    {{TextSize::Normal, "100"}, {TextSize::Larger, "125"}, {TextSize::Large, "150"}, {TextSize::Largest, "175"}}};

/// The keys are locale names.
inline constexpr std::array<Named<Language>, 4> languages{
    {{Language::System, "system"}, {Language::English, "en"}, {Language::German, "de"}, {Language::Chinese, "zh_CN"}}};

/// Of a pen's pressure curve: below 1 a light touch does much, above 1 little.
inline constexpr double minPenExponent = 0.25, maxPenExponent = 4;

/// What a pen's pressure, 0 to 1, counts as.
inline double penPressure(double pressure, double exponent)
{
    return std::pow(pressure, exponent);
}

/// How input of pen and mouse is interpreted.
struct InputPreferences
{
    bool pressureToStrength = true;
    bool pressureToRadius = false;
    bool altMovesView = true; ///< held with a button; else Alt means nothing to the view
    double penExponent = 1;
    MouseModifiers modifiers{}; ///< of the preset of shortcuts

    bool operator==(const InputPreferences&) const = default;
};

/// The number of backups of a file that is saved again, if the user wants them.
inline constexpr int backupCount = 3;

/// What a person chooses once, in the Preferences.
struct Preferences
{
    ThemeChoice theme = ThemeChoice::System;
    Language language = Language::System; ///< of the next start
    TextSize textSize = TextSize::Normal; ///< of the next start
    /// No animation: the view jumps instead of flying, the highlight of a pointer does not pulse.
    bool reducesMotion = false;
    InputPreferences input;
    ShortcutSettings keys{};
    bool keepsBackups = false; ///< backups stay beside a file that is saved again

    bool operator==(const Preferences&) const = default;

    InputPreferences effectiveInput() const
    {
        InputPreferences effective = input;
        effective.modifiers = mouseModifiers(keys.preset);
        return effective;
    }
};
} // namespace ui
