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
/// New is a menu of File; Tool is one of Sculpt; Turn, Material, Background and Reference are menus of View; Files is
/// that of the panel.
enum class MenuId {
    File,
    New,
    Files,
    Edit,
    Sculpt,
    Tool,
    Mask,
    Model,
    View,
    Turn,
    Material,
    Background,
    Reference,
    Vr,
    Help
};
enum class Bar { None, Top, Tools, Options };

/// One row an action. Menus, tool bar, shortcut sheet, settings and tests read this table.
struct ActionInfo
{
    MenuId menu;
    const char* id;           ///< objectName of the QAction, key in settings, handle in tests
    const char* text;         ///< untranslated, context "ui::Actions"
    const char* tip;          ///< one sentence, untranslated; %1 is the key that inverts while it is held
    const char* keys;         ///< of the preset Fettle: portable text, several parted by "; "
    const char* icon;         ///< file without its ending: in :/icons, a starter's in :/pictures
    bool startsGroup = false; ///< a line stands before it, in menu and tool bar
    Bar bar = Bar::None;      ///< where it is a button, too
    bool checkable = false;
};

std::span<const ActionInfo> actionTable();

/// The window's actions, made from the table. Shortcuts work in the whole window, those of Files in the widget that the
/// panel adds them to; those of the number pad are not those of the same key elsewhere.
class Actions : public QObject
{
    Q_OBJECT

public:
    explicit Actions(QWidget* window);

    /// Asserts that the id is in the table.
    QAction* get(const QString& id) const;

    /// The same action is called otherwise from now on, where it does something else.
    void rename(const QString& id, const QString& text);

    /// From now on these are the keys, in menus and tool tips too.
    void setKeys(const ShortcutSettings& shortcuts);
    const ShortcutSettings& keys() const { return m_shortcuts; }

    QString menuTitle(MenuId menu) const;
    /// A text of a menu without what only a menu shows.
    static QString plain(QString text);
    /// "Ctrl", as the keyboards of the language have it.
    static QString modifierName(Qt::KeyboardModifier modifier);
    /// What keys do that are held while the mouse works.
    static QString modifierHelp(ShortcutPreset preset);
    /// Returns the buttons of a bar, parted where a line stands between them.
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
