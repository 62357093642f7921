#pragma once

#include "ui/settings/shortcut_preset.h"

#include <cmath>

namespace ui
{
enum class ThemeChoice { System, Light, Dark };
/// Of what the desktop has, in percent.
enum class TextSize { Usual = 100, Larger = 125, Large = 150, Largest = 175 };
enum class Language { System, English, German, Chinese };

inline constexpr std::array<Named<ThemeChoice>, 3> themeChoices{
    {{ThemeChoice::System, "system"}, {ThemeChoice::Light, "light"}, {ThemeChoice::Dark, "dark"}}};

inline double factorOf(TextSize size)
{
    return static_cast<int>(size) / 100.0;
}

inline constexpr std::array<Named<TextSize>, 4> textSizes{
    {{TextSize::Usual, "100"}, {TextSize::Larger, "125"}, {TextSize::Large, "150"}, {TextSize::Largest, "175"}}};

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

/// How pen and mouse are taken.
struct HandHabits
{
    bool pressureToStrength = true;
    bool pressureToRadius = false;
    bool altMovesView = true; ///< held with a button; else Alt means nothing to the view
    double penExponent = 1;
    HeldKeys held{}; ///< as the preset of keys has it

    bool operator==(const HandHabits&) const = default;
};

/// Of a file that is saved again, if a person wishes so.
inline constexpr int keptVersions = 3;

/// What a person chooses once, in the Preferences.
struct Preferences
{
    ThemeChoice theme = ThemeChoice::System;
    Language language = Language::System; ///< of the next start
    TextSize textSize = TextSize::Usual;  ///< of the next start
    /// Nothing moves that nobody moves: the view goes at once where it is sent, a light stands still.
    bool isCalm = false;
    HandHabits hand;
    KeyChoice keys{};
    bool keepsVersions = false; ///< what a file held stays beside it when it is saved again

    bool operator==(const Preferences&) const = default;

    HandHabits habits() const
    {
        HandHabits habits = hand;
        habits.held = heldKeys(keys.preset);
        return habits;
    }
};
} // namespace ui
