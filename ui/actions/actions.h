#pragma once

#include "ui/actions/shortcut_map.h"

#include <QHash>
#include <QObject>

#include <span>

class QAction;
class QKeyEvent;
class QMenu;
class QToolBar;
class QWidget;

namespace ui
{
/// Menus. New is a submenu of File, Tool of Sculpt, and Area of Model. Turn, Material, Background and Reference are
/// submenus of View. Files is the menu of the Files panel.
enum class MenuId {
    File,
    New,
    Files,
    Edit,
    Sculpt,
    Tool,
    Mask,
    Model,
    Parts,
    Area,
    View,
    Turn,
    Material,
    Background,
    Reference,
    Vr,
    Help
};
enum class Bar { None, Top, Tools, Options };

/// A row of the action table. Menus, tool bars, the shortcut page, settings and tests read the table.
struct ActionInfo
{
    MenuId menu;
    const char* id;           ///< objectName of the QAction, key in the settings, name in tests
    const char* text;         ///< menu text, untranslated; translation context "ui::Actions"
    const char* tip;          ///< one sentence, untranslated; %1 is replaced by the modifier key that inverts the brush
    const char* keys;         ///< default shortcuts (preset Fettle) in Qt's portable text, separated by "; "
    const char* icon;         ///< file name without its suffix, in :/icons (menu New: in :/pictures)
    bool startsGroup = false; ///< a separator precedes the action in menus and tool bars
    Bar bar = Bar::None;      ///< tool bar that has a button for the action
    bool checkable = false;
};

std::span<const ActionInfo> actionTable();

/// Creates and owns the window's actions, one for each row of the table. Shortcuts work in the whole window, except
/// those of the menu Files, which work in the widget that the panel adds them to. A key of the number pad and the
/// corresponding main key are different shortcuts.
class Actions : public QObject
{
    Q_OBJECT

public:
    explicit Actions(QWidget* window);

    /// Precondition: the id is in the table (asserted).
    QAction* get(const QString& id) const;

    /// Changes the text of an action whose effect depends on the state.
    void rename(const QString& id, const QString& text);

    /// Replaces all shortcuts and updates menus and tool tips.
    void setKeys(const ShortcutSettings& shortcuts);
    const ShortcutSettings& keys() const { return m_shortcuts; }

    QString menuTitle(MenuId menu) const;
    /// Returns a menu text without mnemonic and ellipsis.
    static QString plain(QString text);
    /// Returns the name of a modifier key in the language of the window, such as "Ctrl".
    static QString modifierName(Qt::KeyboardModifier modifier);
    /// Returns a description of the modifier keys that change what the mouse does.
    static QString modifierHelp(ShortcutPreset preset);
    /// Returns the buttons of a bar, divided into groups at the separators.
    QList<QList<QAction*>> groups(Bar which) const;
    void fill(QMenu* menu, MenuId which) const;
    void fill(QToolBar* bar, Bar which) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QString ownerOf(const QKeyEvent& event) const;
    QAction* make(const ActionInfo& row, QWidget* window);

    QHash<QString, QAction*> m_actions;
    ShortcutSettings m_shortcuts;
    ShortcutMap m_keys;
};
} // namespace ui
