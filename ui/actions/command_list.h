#pragma once

#include <QTreeWidget>

class QAction;

namespace ui
{
class Actions;

/// A list of all actions of the window, grouped by menu, with their keys and tips. Thread: gui.
class CommandList : public QTreeWidget
{
    Q_OBJECT

public:
    enum Column { Name, Key, Tip, Columns };

    /// Precondition: `actions` outlives the list.
    explicit CommandList(const Actions& actions, QWidget* parent = nullptr);

    /// Returns the width at which no column is truncated, in pixels.
    int wholeWidth() const;

    /// Returns null if the item is the heading of a menu.
    static QAction* actionOf(const QTreeWidgetItem* item);
    QTreeWidgetItem* itemOf(const QString& id) const;
    static void showKeys(QTreeWidgetItem* item, const QList<QKeySequence>& keys);

    /// Shows only the actions in which each word occurs in name, keys, tip, menu or synonyms. Selects the best enabled
    /// match: an action named `words`, else one whose name begins with `words` or that has `words` as a synonym, else
    /// any other. Empty `words` show all actions and select nothing.
    void filter(const QString& words);
};
} // namespace ui
