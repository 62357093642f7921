#pragma once

#include "ui/settings/view_appearance.h"

#include <QMap>
#include <QString>

namespace ui
{
/// The sets of keys to begin with.
enum class ShortcutPreset { Fettle, Blender, ZBrush };

inline constexpr std::array<Named<ShortcutPreset>, 3> shortcutPresets{
    {{ShortcutPreset::Fettle, "fettle"}, {ShortcutPreset::Blender, "blender"}, {ShortcutPreset::ZBrush, "zbrush"}}};

/// The shortcuts of the commands: a preset and what the user changed.
struct ShortcutSettings
{
    ShortcutPreset preset = ShortcutPreset::Fettle;
    QMap<QString, QString> custom; ///< by an action's id: its keys as portable text, parted by "; "; empty: none

    bool operator==(const ShortcutSettings&) const = default;
};

/// What modifier keys do while the mouse is used, by preset. Shift smooths in all of them.
struct MouseModifiers
{
    Qt::KeyboardModifier invert = Qt::ControlModifier;
    /// The right button orbits, with Alt it pans, with Ctrl it zooms; Alt and left pan beside the model and are the
    /// brush's on it.
    bool rightOrbits = false;

    bool operator==(const MouseModifiers&) const = default;
};

constexpr MouseModifiers mouseModifiers(ShortcutPreset preset)
{
    return preset == ShortcutPreset::ZBrush ? MouseModifiers{Qt::AltModifier, true} : MouseModifiers{};
}
} // namespace ui
