#pragma once

#include <QHash>
#include <QIcon>
#include <QKeySequence>
#include <QObject>

#include <span>

class QAction;
class QWidget;

namespace ui
{
enum class MenuId { File, Edit, Sculpt, View, Help };

/// One row an action. Menus, tool bar, shortcut sheet, settings and tests read this table.
struct ActionInfo
{
    const char* id;   ///< objectName of the QAction, key in settings, handle in tests
    const char* text; ///< untranslated, context "ui::Actions"
    const char* tip;  ///< one sentence, untranslated
    const char* keys; ///< portable text, several parted by "; "
    const char* icon; ///< file in :/icons without ending, or empty
    MenuId menu;
    bool startsGroup = false; ///< a separator stands before it
    bool checkable = false;
};

std::span<const ActionInfo> actionTable();

/// The window's actions, made from the table. Shortcuts work in the whole window.
class Actions : public QObject
{
    Q_OBJECT

public:
    explicit Actions(QWidget* window);

    /// Asserts that the id is in the table.
    QAction* get(const QString& id) const;
    QString menuTitle(MenuId menu) const;
    /// In table order; a null pointer stands for a separator.
    QList<QAction*> menu(MenuId menu) const;

private:
    QHash<QString, QAction*> m_actions;
};
} // namespace ui
