#include "ui/actions/shortcut_map.h"

#include "ui/actions/actions.h"

#include <algorithm>
#include <optional>

namespace ui
{
namespace
{
/// Where a preset departs from the action table.
struct Departure
{
    KeyPreset preset;
    const char* id;
    const char* keys;
};

// clang-format off
constexpr Departure departures[] = {
    {KeyPreset::Blender, "tool.pull", "V; 1"},
    {KeyPreset::Blender, "tool.inflate", "I; 9"},
    {KeyPreset::Blender, "tool.clay", "C; 7"},
    {KeyPreset::Blender, "tool.flatten", "Shift+T; 3"},
    {KeyPreset::Blender, "tool.smooth", "S; 4"},
    {KeyPreset::Blender, "tool.crease", "Shift+C; 8"},
    {KeyPreset::Blender, "tool.grab", "G; 6"},
    {KeyPreset::Blender, "brush.add", "Shift+A"},
    {KeyPreset::Blender, "brush.color", "N"},
    {KeyPreset::Blender, "color.pick", "Shift+X"},
    {KeyPreset::Blender, "color.swap", "Shift+N"},
    {KeyPreset::Blender, "model.remesh", "Ctrl+R"},
    {KeyPreset::Blender, "view.frame", "Home; Num+."},
    {KeyPreset::Blender, "view.wireframe", "Shift+Z"},
    {KeyPreset::Blender, "view.ground", "Ctrl+G"},
    {KeyPreset::Blender, "help.keys", "F3; F1"},

    {KeyPreset::ZBrush, "tool.layer", "Shift+L"},
    {KeyPreset::ZBrush, "tool.pinch", "I"},
    {KeyPreset::ZBrush, "brush.radius", "S"},
    {KeyPreset::ZBrush, "brush.strength", "U"},
    {KeyPreset::ZBrush, "brush.steady", "L"},
    {KeyPreset::ZBrush, "topology.uniform", "Shift+U"},
    {KeyPreset::ZBrush, "brush.color", "Shift+C"},
    {KeyPreset::ZBrush, "color.pick", "C"},
    {KeyPreset::ZBrush, "color.swap", "V"},
    {KeyPreset::ZBrush, "view.frame", "F; Home"},
    {KeyPreset::ZBrush, "view.wireframe", "Shift+F"},
    {KeyPreset::ZBrush, "view.orthographic", "P; Num+5"},
    {KeyPreset::ZBrush, "view.ground", "Shift+P"},
};
// clang-format on

Keys listed(const char* keys)
{
    return *keys ? QKeySequence::listFromString(QLatin1StringView(keys)) : Keys();
}

Keys presetKeys(KeyPreset preset, const ActionInfo& row)
{
    for (const Departure& departure : departures)
        if (departure.preset == preset && qstrcmp(departure.id, row.id) == 0)
            return listed(departure.keys);
    return listed(row.keys);
}

/// A person's keys as they are stored; nothing if they are not keys that a command can have.
std::optional<Keys> read(const QString& text, const QString& id)
{
    if (text.isEmpty())
        return Keys();
    const Keys keys = QKeySequence::listFromString(text);
    if (keys.size() > mostKeys ||
        std::ranges::any_of(keys, [&](const QKeySequence& key) { return problemOf(key, id) != KeyProblem::None; }))
        return {};
    return keys;
}
} // namespace

KeyProblem problemOf(const QKeySequence& sequence, const QString& id)
{
    if (presetKeys(KeyPreset::Fettle, id).contains(sequence))
        return KeyProblem::None;
    if (sequence.count() != 1)
        return KeyProblem::Held;
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
        return KeyProblem::Held;
    case Qt::Key_Escape:
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Menu:
    case Qt::Key_F10:
        return KeyProblem::Widgets;
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
        return held & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier) ? KeyProblem::None
                                                                                 : KeyProblem::Widgets;
    default:
        const bool isLetter = QChar::isLetter(static_cast<char32_t>(key));
        return held == Qt::AltModifier && isLetter ? KeyProblem::Menus : KeyProblem::None;
    }
}

bool isFixed(const QString& id)
{
    return id == QLatin1StringView("edit.stop");
}

Keys presetKeys(KeyPreset preset, const QString& id)
{
    const auto row = std::ranges::find_if(actionTable(),
                                          [&](const ActionInfo& action) { return id == QLatin1StringView(action.id); });
    return row != actionTable().end() ? presetKeys(preset, *row) : Keys();
}

KeyMap::KeyMap(const KeyChoice& choice)
{
    const auto own = [&](const QString& id) {
        const auto found = choice.own.constFind(id);
        return found != choice.own.constEnd() && !isFixed(id) ? read(*found, id) : std::nullopt;
    };
    for (const ActionInfo& row : actionTable())
        if (const std::optional<Keys> keys = own(QLatin1StringView(row.id)))
            give(QLatin1StringView(row.id), *keys);
    for (const ActionInfo& row : actionTable())
        if (!own(QLatin1StringView(row.id)))
            give(QLatin1StringView(row.id), presetKeys(choice.preset, row));
}

void KeyMap::give(const QString& id, const Keys& keys)
{
    for (const QKeySequence& key : keys) {
        if (m_owners.contains(key))
            continue;
        m_owners.insert(key, id);
        m_keys[id] << key;
    }
}

KeyChoice withKeys(KeyChoice choice, const QString& id, const Keys& keys)
{
    if (keys == presetKeys(choice.preset, id))
        choice.own.remove(id);
    else
        choice.own.insert(id, QKeySequence::listToString(keys));
    return choice;
}
} // namespace ui
