#pragma once

#include "ui/settings/shortcut_preset.h"

#include <QHash>
#include <QKeySequence>
#include <QList>

namespace ui
{
using Keys = QList<QKeySequence>;

inline constexpr qsizetype maxKeys = 2; ///< largest number of shortcuts of an action

/// Reasons why a key cannot be a shortcut.
enum class ShortcutProblem {
    None,
    Modifier, ///< not a single key, or only a modifier key or lock key
    Widgets,  ///< navigates or types in panels and dialogs
    Menus,    ///< Alt with a letter opens a menu or activates a control
};
/// Returns the reason why the action `id` cannot have this key. Keys that the preset Fettle gives to that action are
/// always allowed.
ShortcutProblem problemOf(const QKeySequence& key, const QString& id = {});

/// Returns true if the keys of the action cannot be changed. Only Stop (Escape) is fixed, because Escape has other uses
/// too.
bool isFixed(const QString& id);

/// Returns the preset's keys of the action; an empty list if there is no such action.
Keys presetKeys(ShortcutPreset preset, const QString& id);

/// The shortcuts of each action of the table. No key belongs to two actions: the user's keys win over the preset's, and
/// then the earlier row of the table wins. Invalid or forbidden keys in the settings are ignored.
class ShortcutMap
{
public:
    explicit ShortcutMap(const ShortcutSettings& shortcuts = {});

    /// Returns the keys of the action; may be empty.
    Keys keys(const QString& id) const { return m_keys.value(id); }
    /// Returns the id of the action that has the key; empty if no action has it.
    QString owner(const QKeySequence& key) const { return m_owners.value(key); }

private:
    void assign(const QString& id, const Keys& keys);

    QHash<QString, Keys> m_keys;
    QHash<QKeySequence, QString> m_owners;
};

/// Returns the settings after the action got these keys. Keys equal to the preset's are not stored.
ShortcutSettings withKeys(ShortcutSettings shortcuts, const QString& id, const Keys& keys);
} // namespace ui
