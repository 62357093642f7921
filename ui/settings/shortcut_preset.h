#pragma once

#include "ui/settings/view_appearance.h"

#include <QMap>
#include <QString>

namespace ui
{
/// Built-in sets of shortcuts.
enum class ShortcutPreset { Fettle, Blender, ZBrush };

inline constexpr std::array<Named<ShortcutPreset>, 3> shortcutPresets{
    {{ShortcutPreset::Fettle, "fettle"}, {ShortcutPreset::Blender, "blender"}, {ShortcutPreset::ZBrush, "zbrush"}}};

/// The shortcuts of the commands: a preset, and the user's changes to it.
struct ShortcutSettings
{
    ShortcutPreset preset = ShortcutPreset::Fettle;
    /// changed keys by action id: portable text, separated by "; "; an empty text means no keys
    QMap<QString, QString> custom;

    bool operator==(const ShortcutSettings&) const = default;
};

/// Effects of modifier keys during mouse input, by preset. Shift smooths in every preset.
struct MouseModifiers
{
    Qt::KeyboardModifier invert = Qt::ControlModifier;
    /// The right button orbits; with Alt it pans, with Ctrl it zooms. Alt with the left button off the model pans. Alt
    /// has these effects only if InputPreferences::altMovesView is set.
    bool rightOrbits = false;

    bool operator==(const MouseModifiers&) const = default;
};

constexpr MouseModifiers mouseModifiers(ShortcutPreset preset)
{
    return preset == ShortcutPreset::ZBrush ? MouseModifiers{Qt::AltModifier, true} : MouseModifiers{};
}
} // namespace ui
