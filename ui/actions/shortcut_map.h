#pragma once

#include "ui/settings/shortcut_preset.h"

#include <QHash>
#include <QKeySequence>
#include <QList>

namespace ui
{
using Keys = QList<QKeySequence>;

inline constexpr qsizetype maxKeys = 2; ///< of one action

/// The reason why no action can have a key.
enum class ShortcutProblem {
    None,
    Modifier, ///< it is no single key, or only changes the meaning of the mouse and of other keys
    Widgets,  ///< it moves or types in panels and dialogs
    Menus,    ///< Alt with a letter opens a menu, or reaches a control
};
/// Returns the reason why the action `id` cannot have this key. A key that Fettle's own preset gives it has none.
ShortcutProblem problemOf(const QKeySequence& key, const QString& id = {});

/// Whether the key of the action cannot be changed. It is Escape, which many other things use too.
bool isFixed(const QString& id);

/// Returns the preset's keys of the action; none if there is no such action.
Keys presetKeys(ShortcutPreset preset, const QString& id);

/// The keys of each action of the table. No key belongs to two actions. Settings that are unknown, cannot be read or
/// are not allowed are ignored. Keys that the user chose go before the preset's; among equals the table's order
/// decides.
class ShortcutMap
{
public:
    explicit ShortcutMap(const ShortcutSettings& shortcuts = {});

    /// Returns the keys of the action; none if it has none.
    Keys keys(const QString& id) const { return m_keys.value(id); }
    /// Returns the id of the action that has the key; empty if there is none.
    QString owner(const QKeySequence& key) const { return m_owners.value(key); }

private:
    void assign(const QString& id, const Keys& keys);

    QHash<QString, Keys> m_keys;
    QHash<QKeySequence, QString> m_owners;
};

/// Returns the settings with these keys for the action. Keys that are the preset's are not stored.
ShortcutSettings withKeys(ShortcutSettings shortcuts, const QString& id, const Keys& keys);
} // namespace ui
