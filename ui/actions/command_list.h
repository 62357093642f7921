#pragma once

#include <QTreeWidget>

class QAction;

namespace ui
{
class Actions;

/// Every action of the window, by menu, with its keys and what it does. Thread: gui.
class CommandList : public QTreeWidget
{
    Q_OBJECT

public:
    enum Column { Name, Key, Tip, Columns };

    /// The actions must outlive it.
    explicit CommandList(const Actions& actions, QWidget* parent = nullptr);

    /// What all columns need to show all their words, in pixels.
    int wholeWidth() const;

    /// Null for a menu's line.
    static QAction* actionOf(const QTreeWidgetItem* item);
    QTreeWidgetItem* itemOf(const QString& id) const;
    static void showKeys(QTreeWidgetItem* item, const QList<QKeySequence>& keys);

    /// Hides what does not hold each of the words in name, keys, tip, menu or synonyms. Of those that do and are
    /// enabled the first that is called so becomes the current one, or is called so at first or by people, or has the
    /// words at all; none if there are no words.
    void filter(const QString& words);
};
} // namespace ui
