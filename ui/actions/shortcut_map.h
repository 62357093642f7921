#pragma once

#include "ui/settings/shortcut_preset.h"

#include <QHash>
#include <QKeySequence>
#include <QList>

namespace ui
{
using Keys = QList<QKeySequence>;

inline constexpr qsizetype maxKeys = 2; ///< a command

/// Why a key can be no command's.
enum class ShortcutProblem {
    None,
    Modifier, ///< alone it does nothing but change what mouse and other keys do
    Widgets,  ///< moves and types in panels and dialogs
    Menus,    ///< Alt with a letter: opens a menu, or reaches a control
};
/// What the preset gives a command is no problem to it.
ShortcutProblem problemOf(const QKeySequence& key, const QString& id = {});

/// Escape is part of too many things to be another key.
bool isFixed(const QString& id);

/// The preset's keys of the action; none if there is no such action.
Keys presetKeys(ShortcutPreset preset, const QString& id);

/// Which keys each action of the table has: never one key for two. What is unknown, cannot be read or cannot be in a
/// choice is as if it were not there. Keys that a person chose go before the preset's, and among equals the table's
/// order decides.
class ShortcutMap
{
public:
    explicit ShortcutMap(const ShortcutSettings& shortcuts = {});

    Keys keys(const QString& id) const { return m_keys.value(id); }
    /// The id of the action; empty if there is none.
    QString owner(const QKeySequence& key) const { return m_owners.value(key); }

private:
    void assign(const QString& id, const Keys& keys);

    QHash<QString, Keys> m_keys;
    QHash<QKeySequence, QString> m_owners;
};

/// The choice with these keys for the action, which are kept only if they are not the preset's.
ShortcutSettings withKeys(ShortcutSettings shortcuts, const QString& id, const Keys& keys);
} // namespace ui
