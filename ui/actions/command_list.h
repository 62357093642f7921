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

    /// Hides the actions that lack any of the words in name, keys, tip, menu or synonyms. Selects the best enabled
    /// match: its name is `words`, else its name begins with them or they are one of its synonyms, else any match.
    /// Empty `words` select nothing.
    void filter(const QString& words);
};
} // namespace ui
