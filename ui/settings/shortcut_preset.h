#pragma once

#include "ui/settings/view_appearance.h"

#include <QMap>
#include <QString>

namespace ui
{
/// The sets of keys to begin with.
enum class KeyPreset { Fettle, Blender, ZBrush };

inline constexpr std::array<Named<KeyPreset>, 3> keyPresets{
    {{KeyPreset::Fettle, "fettle"}, {KeyPreset::Blender, "blender"}, {KeyPreset::ZBrush, "zbrush"}}};

/// Which keys the commands have: a preset, and what a person changed of it.
struct KeyChoice
{
    KeyPreset preset = KeyPreset::Fettle;
    QMap<QString, QString> own; ///< by an action's id: its keys as portable text, parted by "; "; empty: none

    bool operator==(const KeyChoice&) const = default;
};

/// What a preset makes of keys that are held while the mouse works. Shift smooths in all.
struct HeldKeys
{
    Qt::KeyboardModifier invert = Qt::ControlModifier;
    /// The right button orbits, with Alt it pans, with Ctrl it zooms; Alt and left pan beside the model and are the
    /// brush's on it.
    bool rightOrbits = false;

    bool operator==(const HeldKeys&) const = default;
};

constexpr HeldKeys heldKeys(KeyPreset preset)
{
    return preset == KeyPreset::ZBrush ? HeldKeys{Qt::AltModifier, true} : HeldKeys{};
}
} // namespace ui
