#include "ui/actions/command_list.h"

#include "ui/actions/actions.h"
#include "ui/actions/synonyms.h"

#include <QAction>
#include <QHeaderView>
#include <QRegularExpression>
#include <QScrollBar>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int actionRole = Qt::UserRole, synonymsRole = Qt::UserRole + 1;

bool containsAll(const QTreeWidgetItem* item, const QStringList& words)
{
    QStringList texts = item->data(CommandList::Name, synonymsRole).toStringList();
    texts << item->parent()->text(CommandList::Name);
    for (const int column : {CommandList::Name, CommandList::Key, CommandList::Tip})
        texts << item->text(column);
    const QString text = texts.join(u' ');
    return std::ranges::all_of(words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}
/// Returns the rank of an item, smaller is better. 0: the name is `words`. 1: the name lists `words` between commas.
/// 2: the name begins with `words`, or a synonym equals `words`. 3: any other match.
int rank(const QTreeWidgetItem* item, const QString& words)
{
    static const QRegularExpression comma(QStringLiteral("[,\u3001\uff0c]\\s*"));
    const QString name = item->text(CommandList::Name), wanted = words.trimmed();
    if (name.compare(wanted, Qt::CaseInsensitive) == 0)
        return 0;
    if (name.split(comma).contains(wanted, Qt::CaseInsensitive))
        return 1;
    const bool isSynonym =
        item->data(CommandList::Name, synonymsRole).toStringList().contains(wanted, Qt::CaseInsensitive);
    return isSynonym || name.startsWith(wanted, Qt::CaseInsensitive) ? 2 : 3;
}
} // namespace

CommandList::CommandList(const Actions& actions, QWidget* parent) : QTreeWidget(parent)
{
    setColumnCount(Columns);
    setHeaderLabels({tr("Command"), tr("Key"), tr("What it does")});
    setRootIsDecorated(false);
    QHash<MenuId, QTreeWidgetItem*> menus;
    for (const ActionInfo& row : actionTable()) {
        QTreeWidgetItem*& menu = menus[row.menu];
        if (!menu) {
            menu = new QTreeWidgetItem(this, {Actions::plain(actions.menuTitle(row.menu))});
            menu->setFlags(Qt::ItemIsEnabled);
            menu->setFirstColumnSpanned(true);
            QFont font = menu->font(Name);
            font.setBold(true);
            menu->setFont(Name, font);
        }
        QAction* action = actions.get(QLatin1StringView(row.id));
        auto* item = new QTreeWidgetItem(menu, {Actions::plain(action->text()), {}, action->statusTip()});
        showKeys(item, action->shortcuts());
        item->setIcon(Name, action->icon());
        item->setData(Name, actionRole, QVariant::fromValue(action));
        item->setData(Name, synonymsRole, synonymsOf(action->objectName()));
    }
    expandAll();
    for (const Column column : {Name, Key, Tip})
        resizeColumnToContents(column);
}

int CommandList::wholeWidth() const
{
    return header()->length() + verticalScrollBar()->sizeHint().width() + 2 * frameWidth();
}

QAction* CommandList::actionOf(const QTreeWidgetItem* item)
{
    return item ? item->data(Name, actionRole).value<QAction*>() : nullptr;
}

QTreeWidgetItem* CommandList::itemOf(const QString& id) const
{
    for (int m = 0; m < topLevelItemCount(); ++m)
        for (int i = 0; i < topLevelItem(m)->childCount(); ++i)
            if (QTreeWidgetItem* item = topLevelItem(m)->child(i); actionOf(item)->objectName() == id)
                return item;
    return nullptr;
}

void CommandList::showKeys(QTreeWidgetItem* item, const QList<QKeySequence>& keys)
{
    item->setText(Key, QKeySequence::listToString(keys, QKeySequence::NativeText));
}

void CommandList::filter(const QString& words)
{
    const QStringList parts = words.split(u' ', Qt::SkipEmptyParts);
    setCurrentItem(nullptr);
    for (int m = 0; m < topLevelItemCount(); ++m) {
        QTreeWidgetItem* menu = topLevelItem(m);
        bool any = false;
        for (int i = 0; i < menu->childCount(); ++i) {
            QTreeWidgetItem* item = menu->child(i);
            const bool found = containsAll(item, parts);
            item->setHidden(!found);
            any = any || found;
            const bool isBetter = !currentItem() || rank(item, words) < rank(currentItem(), words);
            if (found && !item->isDisabled() && !parts.isEmpty() && isBetter)
                setCurrentItem(item);
        }
        menu->setHidden(!any);
    }
}
} // namespace ui
