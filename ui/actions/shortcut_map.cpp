#include "ui/actions/shortcut_map.h"

#include "ui/actions/actions.h"

#include <algorithm>
#include <optional>

namespace ui
{
namespace
{
/// Keys of an action in one preset where they differ from the action table.
struct PresetOverride
{
    ShortcutPreset preset;
    const char* id;
    const char* keys;
};

// clang-format off
constexpr PresetOverride presetOverrides[] = {
    {ShortcutPreset::Blender, "tool.pull", "V; 1"},
    {ShortcutPreset::Blender, "tool.inflate", "I; 9"},
    {ShortcutPreset::Blender, "tool.clay", "C; 7"},
    {ShortcutPreset::Blender, "tool.flatten", "Shift+T; 3"},
    {ShortcutPreset::Blender, "tool.smooth", "S; 4"},
    {ShortcutPreset::Blender, "tool.crease", "Shift+C; 8"},
    {ShortcutPreset::Blender, "tool.grab", "G; 6"},
    {ShortcutPreset::Blender, "brush.add", "Shift+A"},
    {ShortcutPreset::Blender, "brush.color", "N"},
    {ShortcutPreset::Blender, "color.pick", "Shift+X"},
    {ShortcutPreset::Blender, "color.swap", "Shift+N"},
    {ShortcutPreset::Blender, "model.remesh", "Ctrl+R"},
    {ShortcutPreset::Blender, "model.transform", "Ctrl+T"},
    {ShortcutPreset::Blender, "view.frame", "Home; Num+."},
    {ShortcutPreset::Blender, "view.wireframe", "Shift+Z"},
    {ShortcutPreset::Blender, "view.ground", "Ctrl+G"},
    {ShortcutPreset::Blender, "help.keys", "F3; F1"},

    {ShortcutPreset::ZBrush, "tool.layer", "Shift+L"},
    {ShortcutPreset::ZBrush, "model.transform", "Ctrl+T"},
    {ShortcutPreset::ZBrush, "tool.pinch", "I"},
    {ShortcutPreset::ZBrush, "brush.radius", "S"},
    {ShortcutPreset::ZBrush, "brush.strength", "U"},
    {ShortcutPreset::ZBrush, "brush.steady", "L"},
    {ShortcutPreset::ZBrush, "topology.uniform", "Shift+U"},
    {ShortcutPreset::ZBrush, "brush.color", "Shift+C"},
    {ShortcutPreset::ZBrush, "color.pick", "C"},
    {ShortcutPreset::ZBrush, "color.swap", "V"},
    {ShortcutPreset::ZBrush, "view.frame", "F; Home"},
    {ShortcutPreset::ZBrush, "view.wireframe", "Shift+F"},
    {ShortcutPreset::ZBrush, "view.orthographic", "P; Num+5"},
    {ShortcutPreset::ZBrush, "view.ground", "Shift+P"},
};
// clang-format on

Keys listed(const char* keys)
{
    return *keys ? QKeySequence::listFromString(QLatin1StringView(keys)) : Keys();
}

Keys presetKeys(ShortcutPreset preset, const ActionInfo& row)
{
    for (const PresetOverride& entry : presetOverrides)
        if (entry.preset == preset && qstrcmp(entry.id, row.id) == 0)
            return listed(entry.keys);
    return listed(row.keys);
}

/// Parses the stored keys of a user. Returns nullopt if they contain a key that the action cannot have, or more than
/// maxKeys.
std::optional<Keys> read(const QString& text, const QString& id)
{
    if (text.isEmpty())
        return Keys();
    const Keys keys = QKeySequence::listFromString(text);
    if (keys.size() > maxKeys ||
        std::ranges::any_of(keys, [&](const QKeySequence& key) { return problemOf(key, id) != ShortcutProblem::None; }))
        return {};
    return keys;
}
} // namespace

ShortcutProblem problemOf(const QKeySequence& sequence, const QString& id)
{
    if (presetKeys(ShortcutPreset::Fettle, id).contains(sequence))
        return ShortcutProblem::None;
    if (sequence.count() != 1)
        return ShortcutProblem::Modifier;
    const Qt::Key key = sequence[0].key();
    const Qt::KeyboardModifiers held = sequence[0].keyboardModifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    switch (key) {
    case Qt::Key_unknown:
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
    case Qt::Key_Super_L:
    case Qt::Key_Super_R:
    case Qt::Key_CapsLock:
    case Qt::Key_NumLock:
    case Qt::Key_ScrollLock:
        return ShortcutProblem::Modifier;
    case Qt::Key_Escape:
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Menu:
    case Qt::Key_F10:
        return ShortcutProblem::Widgets;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_End:
    case Qt::Key_Plus:
    case Qt::Key_Minus:
    case Qt::Key_0:
        return held & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier) ? ShortcutProblem::None
                                                                                 : ShortcutProblem::Widgets;
    default:
        const bool isLetter = QChar::isLetter(static_cast<char32_t>(key));
        return held == Qt::AltModifier && isLetter ? ShortcutProblem::Menus : ShortcutProblem::None;
    }
}

bool isFixed(const QString& id)
{
    return id == QLatin1StringView("edit.stop");
}

Keys presetKeys(ShortcutPreset preset, const QString& id)
{
    const auto row = std::ranges::find_if(actionTable(),
                                          [&](const ActionInfo& action) { return id == QLatin1StringView(action.id); });
    return row != actionTable().end() ? presetKeys(preset, *row) : Keys();
}

ShortcutMap::ShortcutMap(const ShortcutSettings& shortcuts)
{
    const auto own = [&](const QString& id) {
        const auto found = shortcuts.custom.constFind(id);
        return found != shortcuts.custom.constEnd() && !isFixed(id) ? read(*found, id) : std::nullopt;
    };
    for (const ActionInfo& row : actionTable())
        if (const std::optional<Keys> keys = own(QLatin1StringView(row.id)))
            assign(QLatin1StringView(row.id), *keys);
    for (const ActionInfo& row : actionTable())
        if (!own(QLatin1StringView(row.id)))
            assign(QLatin1StringView(row.id), presetKeys(shortcuts.preset, row));
}

void ShortcutMap::assign(const QString& id, const Keys& keys)
{
    for (const QKeySequence& key : keys) {
        if (m_owners.contains(key))
            continue;
        m_owners.insert(key, id);
        m_keys[id] << key;
    }
}

ShortcutSettings withKeys(ShortcutSettings shortcuts, const QString& id, const Keys& keys)
{
    if (keys == presetKeys(shortcuts.preset, id))
        shortcuts.custom.remove(id);
    else
        shortcuts.custom.insert(id, QKeySequence::listToString(keys));
    return shortcuts;
}
} // namespace ui
