#pragma once

#include "key_choice.h"

namespace ui
{
enum class ThemeChoice { System, Light, Dark };
enum class Language { System, English, German, Chinese };

inline constexpr std::array<Named<ThemeChoice>, 3> themeChoices{
    {{ThemeChoice::System, "system"}, {ThemeChoice::Light, "light"}, {ThemeChoice::Dark, "dark"}}};

/// The keys are locale names.
inline constexpr std::array<Named<Language>, 4> languages{
    {{Language::System, "system"}, {Language::English, "en"}, {Language::German, "de"}, {Language::Chinese, "zh_CN"}}};

/// How pen and mouse are taken.
struct HandHabits
{
    bool pressureToStrength = true;
    bool pressureToRadius = false;
    bool altMovesView = true; ///< held with a button; else Alt means nothing to the view
    HeldKeys held{};          ///< as the preset of keys has it

    bool operator==(const HandHabits&) const = default;
};

/// What a person chooses once, in the Preferences.
struct Preferences
{
    ThemeChoice theme = ThemeChoice::System;
    Language language = Language::System; ///< of the next start
    HandHabits hand;
    KeyChoice keys{};

    bool operator==(const Preferences&) const = default;

    HandHabits habits() const
    {
        HandHabits habits = hand;
        habits.held = heldKeys(keys.preset);
        return habits;
    }
};
} // namespace ui
