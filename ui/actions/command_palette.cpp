#include "ui/actions/command_palette.h"

#include "ui/actions/actions.h"
#include "ui/actions/command_list.h"
#include "ui/widgets/panel_layout.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QSize defaultSize{820, 480};
constexpr int maxWidth = 1200; ///< pixels, fits a small screen
} // namespace

CommandPalette::CommandPalette(const Actions& actions, QWidget* parent)
    : QDialog(parent)
    , m_words(new QLineEdit)
    , m_list(new CommandList(actions))
{
    setObjectName(QStringLiteral("commandBox"));
    setWindowTitle(tr("Commands and Keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_words->setPlaceholderText(tr("What do you want to do?"));
    m_words->setAccessibleName(tr("Words of a command"));
    m_words->setClearButtonEnabled(true);
    m_words->installEventFilter(this);
    m_list->setAccessibleName(windowTitle());
    for (const ActionInfo& row : actionTable())
        m_list->itemOf(QLatin1StringView(row.id))->setDisabled(!actions.get(QLatin1StringView(row.id))->isEnabled());

    QVBoxLayout* column = panelLayout(this);
    column->addWidget(m_words);
    column->addWidget(m_list);
    auto* modifierHelp = new QLabel(Actions::modifierHelp(actions.keys().preset));
    modifierHelp->setWordWrap(true);
    column->addWidget(modifierHelp);
    resize(std::clamp(m_list->wholeWidth() + 2 * gap, defaultSize.width(), maxWidth), defaultSize.height());

    connect(m_words, &QLineEdit::textChanged, m_list, &CommandList::filter);
    connect(m_list, &QTreeWidget::itemActivated, this, &CommandPalette::run);
    m_words->setFocus();
}

/// Closes the dialog first, because the action may open another dialog.
void CommandPalette::run()
{
    const QTreeWidgetItem* item = m_list->currentItem();
    if (!item || item->isDisabled() || !CommandList::actionOf(item))
        return;
    QAction* action = CommandList::actionOf(item);
    accept();
    action->trigger();
}

void CommandPalette::step(int by)
{
    QTreeWidgetItem* item = m_list->currentItem();
    do {
        if (!item)
            item = m_list->topLevelItem(0);
        else
            item = by > 0 ? m_list->itemBelow(item) : m_list->itemAbove(item);
    } while (item && (!CommandList::actionOf(item) || item->isDisabled()));
    if (item)
        m_list->setCurrentItem(item);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
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
        run();
        return true;
    default:
        return QDialog::eventFilter(watched, event);
    }
}
} // namespace ui
