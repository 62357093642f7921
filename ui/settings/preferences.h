#pragma once

#include "ui/settings/shortcut_preset.h"

#include <cmath>

namespace ui
{
enum class ThemeChoice { System, Light, Dark };
/// Size of text in percent of the desktop's text size.
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

/// Languages of the program. The keys are locale names.
inline constexpr std::array<Named<Language>, 4> languages{
    {{Language::System, "system"}, {Language::English, "en"}, {Language::German, "de"}, {Language::Chinese, "zh_CN"}}};

/// Limits of the exponent of a pen's pressure curve: below 1 light touches have more effect, above 1 less.
inline constexpr double minPenExponent = 0.25, maxPenExponent = 4;

/// Returns the effective pressure, 0 to 1, for a pen's pressure, 0 to 1.
inline double penPressure(double pressure, double exponent)
{
    return std::pow(pressure, exponent);
}

/// Interpretation of pen and mouse input.
struct InputPreferences
{
    bool pressureToStrength = true;
    bool pressureToRadius = false;
    bool altMovesView = true; ///< Alt with a mouse button moves the view; else Alt has no effect on the view
    double penExponent = 1;
    MouseModifiers modifiers{}; ///< set from the shortcut preset by effectiveInput()

    bool operator==(const InputPreferences&) const = default;
};

/// Number of backups kept when a file is saved again, if the user wants backups.
inline constexpr int backupCount = 3;

/// Choices made in the preferences dialog.
struct Preferences
{
    ThemeChoice theme = ThemeChoice::System;
    Language language = Language::System; ///< takes effect at the next start
    TextSize textSize = TextSize::Normal; ///< takes effect at the next start
    /// disables animation: the view jumps instead of flying, and the highlight of a pointer does not pulse
    bool reducesMotion = false;
    InputPreferences input;
    ShortcutSettings keys{};
    bool keepsBackups = false;        ///< keeps backups beside a file that is saved again
    bool opensObjectsAsParts = false; ///< makes a part of each object of an opened file; else one part of all

    bool operator==(const Preferences&) const = default;

    InputPreferences effectiveInput() const
    {
        InputPreferences effective = input;
        effective.modifiers = mouseModifiers(keys.preset);
        return effective;
    }
};
} // namespace ui
