#include "command_box.h"

#include "actions.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int gap = 8; ///< of the window's spacing grid
constexpr QSize usualSize{820, 480};
enum Column { Name, Key, Tip, Columns };
constexpr int actionRole = Qt::UserRole;

QAction* actionOf(const QTreeWidgetItem* item)
{
    return item->data(Name, actionRole).value<QAction*>();
}

/// Each of the words, anywhere in name, tip or menu.
bool holds(const QTreeWidgetItem* item, const QStringList& words)
{
    const QString text = item->text(Name) + u' ' + item->text(Tip) + u' ' + item->parent()->text(Name);
    return std::ranges::all_of(words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}
} // namespace

CommandBox::CommandBox(const Actions& actions, QWidget* parent)
    : QDialog(parent), m_words(new QLineEdit), m_list(new QTreeWidget)
{
    setObjectName(QStringLiteral("commandBox"));
    setWindowTitle(tr("Commands and Keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_words->setPlaceholderText(tr("What do you want to do?"));
    m_words->setAccessibleName(tr("Words of a command"));
    m_words->setClearButtonEnabled(true);
    m_words->installEventFilter(this);
    m_list->setAccessibleName(windowTitle());
    m_list->setColumnCount(Columns);
    m_list->setHeaderLabels({tr("Command"), tr("Key"), tr("What it does")});
    m_list->setRootIsDecorated(false);
    fill(actions);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap, gap, gap, gap);
    column->setSpacing(gap);
    column->addWidget(m_words);
    column->addWidget(m_list);
    resize(usualSize);

    connect(m_words, &QLineEdit::textChanged, this, &CommandBox::filter);
    connect(m_list, &QTreeWidget::itemActivated, this, &CommandBox::go);
    filter({});
    m_words->setFocus();
}

void CommandBox::fill(const Actions& actions)
{
    QHash<MenuId, QTreeWidgetItem*> menus;
    for (const ActionInfo& row : actionTable()) {
        QTreeWidgetItem*& menu = menus[row.menu];
        if (!menu) {
            menu = new QTreeWidgetItem(m_list, {Actions::plain(actions.menuTitle(row.menu))});
            menu->setFlags(Qt::ItemIsEnabled);
            menu->setFirstColumnSpanned(true);
        }
        QAction* action = actions.get(QLatin1StringView(row.id));
        auto* item = new QTreeWidgetItem(menu, {Actions::plain(action->text()), QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText), action->statusTip()});
        item->setIcon(Name, action->icon());
        item->setData(Name, actionRole, QVariant::fromValue(action));
        item->setDisabled(!action->isEnabled());
    }
    m_list->expandAll();
    for (const Column column : {Name, Key})
        m_list->resizeColumnToContents(column);
}

void CommandBox::filter(const QString& words)
{
    const QStringList parts = words.split(u' ', Qt::SkipEmptyParts);
    m_list->setCurrentItem(nullptr);
    for (int m = 0; m < m_list->topLevelItemCount(); ++m) {
        QTreeWidgetItem* menu = m_list->topLevelItem(m);
        bool any = false;
        for (int i = 0; i < menu->childCount(); ++i) {
            QTreeWidgetItem* item = menu->child(i);
            const bool found = holds(item, parts);
            item->setHidden(!found);
            any = any || found;
            if (found && !item->isDisabled() && !parts.isEmpty() && !m_list->currentItem())
                m_list->setCurrentItem(item);
        }
        menu->setHidden(!any);
    }
}

/// The box goes first: what is done may open another.
void CommandBox::go()
{
    const QTreeWidgetItem* item = m_list->currentItem();
    if (!item || item->isDisabled() || !actionOf(item))
        return;
    QAction* action = actionOf(item);
    accept();
    action->trigger();
}

void CommandBox::step(int by)
{
    QTreeWidgetItem* item = m_list->currentItem();
    do {
        if (!item)
            item = m_list->topLevelItem(0);
        else
            item = by > 0 ? m_list->itemBelow(item) : m_list->itemAbove(item);
    } while (item && (!actionOf(item) || item->isDisabled()));
    if (item)
        m_list->setCurrentItem(item);
}

bool CommandBox::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Down:
        step(1);
        return true;
    case Qt::Key_Up:
        step(-1);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        go();
        return true;
    default:
        return QDialog::eventFilter(watched, event);
    }
}
} // namespace ui
