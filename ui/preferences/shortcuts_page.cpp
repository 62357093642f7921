#include "ui/preferences/shortcuts_page.h"

#include "ui/actions/actions.h"
#include "ui/actions/command_list.h"
#include "ui/widgets/named.h"
#include "ui/widgets/shortcut_edit.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace ui
{
namespace
{
constexpr int keyWidth = 120;

QString presetName(ShortcutPreset preset)
{
    const QString names[] = {ShortcutsPage::tr("Fettle"), ShortcutsPage::tr("Blender"), ShortcutsPage::tr("ZBrush")};
    static_assert(std::size(names) == static_cast<std::size_t>(ShortcutPreset::ZBrush) + 1);
    return names[static_cast<std::size_t>(preset)];
}

QPushButton* button(const char* name, const QString& text, const QString& tip)
{
    auto* made = named(new QPushButton(text), name, tip, Actions::plain(text));
    made->setAutoDefault(false);
    return made;
}
} // namespace

ShortcutsPage::ShortcutsPage(const Actions& actions, QWidget* parent)
    : QWidget(parent)
    , m_actions(actions)
    , m_preset(new QComboBox)
    , m_modifierHelp(new QLabel)
    , m_words(new QLineEdit)
    , m_list(new CommandList(actions))
    , m_name(new QLabel)
    , m_word(new QLabel)
{
    m_words->setObjectName(QStringLiteral("keyWords"));
    m_words->setPlaceholderText(tr("Search for a command or a key"));
    m_words->setAccessibleName(tr("Words of a command"));
    m_words->setToolTip(tr("Shows only commands with these words or this key."));
    m_words->setClearButtonEnabled(true);
    m_modifierHelp->setWordWrap(true);
    named(m_list, "keyList", tr("Every command with its keys. Change the keys of the selected one below."),
          tr("Commands and Keys"));
    m_list->setColumnHidden(CommandList::Tip, true);
    m_list->header()->setSectionResizeMode(CommandList::Name, QHeaderView::ResizeToContents);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(2 * gap, 2 * gap, 2 * gap, 2 * gap);
    column->setSpacing(gap);
    column->addLayout(presetRow());
    column->addWidget(m_modifierHelp);
    column->addWidget(m_words);
    column->addWidget(m_list);
    column->addLayout(editRow());
    column->addLayout(messageRow());

    connect(m_words, &QLineEdit::textChanged, m_list, &CommandList::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::showCurrent);
    connect(m_list, &QTreeWidget::itemActivated, m_edits[0], [this] { m_edits[0]->setFocus(); });
    m_list->setCurrentItem(m_list->topLevelItem(0)->child(0));
}

QLayout* ShortcutsPage::presetRow()
{
    named(m_preset, "keyPreset", tr("Chooses a set of keys. Keys that you changed yourself stay."), tr("Preset"));
    for (const Named<ShortcutPreset>& row : shortcutPresets)
        m_preset->addItem(presetName(row.value), static_cast<int>(row.value));
    connect(m_preset, &QComboBox::activated, this, [this] {
        ShortcutSettings shortcuts = m_shortcuts;
        shortcuts.preset = static_cast<ShortcutPreset>(m_preset->currentData().toInt());
        change(shortcuts);
    });
    m_resetAll = button("resetKeys", tr("Reset A&ll Keys"), tr("Resets all commands to the keys of the preset."));
    connect(m_resetAll, &QPushButton::clicked, this, [this] { change({m_shortcuts.preset, {}}); });
    auto* label = new QLabel(tr("&Preset"));
    label->setBuddy(m_preset);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_preset, 1);
    row->addWidget(m_resetAll);
    return row;
}

QLayout* ShortcutsPage::editRow()
{
    auto* row = new QHBoxLayout;
    row->addWidget(m_name, 1);
    const QString names[] = {tr("First key"), tr("Second key")};
    for (std::size_t place = 0; place < m_edits.size(); ++place) {
        auto* edit = m_edits[place] = new ShortcutEdit;
        named(edit, QStringLiteral("key%1").arg(place + 1),
              tr("Press the new key for the command, or Backspace to remove it."), names[place]);
        edit->setFixedWidth(keyWidth);
        connect(edit, &ShortcutEdit::entered, this, [this, place](const QKeySequence& key) { enter(place, key); });
        row->addWidget(edit);
    }
    m_reset = button("resetKey", tr("R&eset"), tr("Resets the command to the keys of the preset."));
    connect(m_reset, &QPushButton::clicked, this, &ShortcutsPage::reset);
    row->addWidget(m_reset);
    return row;
}

QLayout* ShortcutsPage::messageRow()
{
    m_word->setObjectName(QStringLiteral("keyWord"));
    m_word->setWordWrap(true);
    m_goThere = button("goToKey", tr("&Go There"), tr("Selects the command that uses the key."));
    connect(m_goThere, &QPushButton::clicked, this, &ShortcutsPage::goToOwner);
    auto* row = new QHBoxLayout;
    row->addWidget(m_word, 1);
    row->addWidget(m_goThere);
    m_word->setMinimumHeight(m_goThere->sizeHint().height());
    return row;
}

void ShortcutsPage::setShortcuts(const ShortcutSettings& shortcuts)
{
    m_shortcuts = shortcuts;
    m_keys = ShortcutMap(shortcuts);
    m_preset->setCurrentIndex(m_preset->findData(static_cast<int>(shortcuts.preset)));
    m_modifierHelp->setText(Actions::modifierHelp(shortcuts.preset));
    for (const ActionInfo& row : actionTable()) {
        QTreeWidgetItem* item = m_list->itemOf(QLatin1StringView(row.id));
        CommandList::showKeys(item, m_keys.keys(QLatin1StringView(row.id)));
        QFont font = m_list->font();
        font.setBold(shortcuts.custom.contains(QLatin1StringView(row.id)));
        item->setFont(CommandList::Key, font);
    }
    m_resetAll->setEnabled(!shortcuts.custom.isEmpty());
    showCurrent();
}

void ShortcutsPage::showCurrent()
{
    const QString id = currentId();
    const Keys keys = m_keys.keys(id);
    for (std::size_t place = 0; place < m_edits.size(); ++place) {
        m_edits[place]->setKey(keys.value(static_cast<qsizetype>(place)));
        m_edits[place]->setEnabled(!id.isEmpty() && !isFixed(id));
    }
    m_name->setText(nameOf(id));
    m_reset->setEnabled(m_shortcuts.custom.contains(id));
    showMessage(isFixed(id) ? tr("This key cannot be changed.") : QString());
}

void ShortcutsPage::enter(std::size_t place, const QKeySequence& key)
{
    const QString id = currentId();
    const QString owner = m_keys.owner(key);
    if (const QString why = refusal(key); !key.isEmpty() && !why.isEmpty())
        return showMessage(why);
    if (!key.isEmpty() && !owner.isEmpty() && owner != id)
        return showMessage(tr("%1 is already used by %2.").arg(key.toString(QKeySequence::NativeText), nameOf(owner)),
                           owner);
    Keys keys = m_keys.keys(id);
    keys.resize(maxKeys);
    keys[static_cast<qsizetype>(place)] = key;
    keys.removeAll({});
    if (keys.size() == maxKeys && keys.constFirst() == keys.constLast())
        keys.removeLast();
    change(withKeys(m_shortcuts, id, keys));
}

/// Restores the preset's keys of the command. A key that another command has got meanwhile stays with that command.
void ShortcutsPage::reset()
{
    const QString id = currentId();
    ShortcutSettings shortcuts = m_shortcuts;
    shortcuts.custom.remove(id);
    change(shortcuts);
    for (const QKeySequence& key : presetKeys(shortcuts.preset, id))
        if (const QString owner = m_keys.owner(key); owner != id)
            showMessage(tr("%1 stays with %2.").arg(key.toString(QKeySequence::NativeText), nameOf(owner)), owner);
}

void ShortcutsPage::change(const ShortcutSettings& shortcuts)
{
    setShortcuts(shortcuts);
    Q_EMIT changed(shortcuts);
}

QString ShortcutsPage::refusal(const QKeySequence& key) const
{
    const QString name = key.toString(QKeySequence::NativeText);
    switch (problemOf(key, currentId())) {
    case ShortcutProblem::None:
        break;
    case ShortcutProblem::Modifier:
        return tr("A modifier key cannot be a shortcut on its own.");
    case ShortcutProblem::Widgets:
        return tr("%1 is needed to move and type in panels and dialogs.").arg(name);
    case ShortcutProblem::Menus:
        return tr("Alt with a letter opens menus and reaches controls.");
    }
    return {};
}

void ShortcutsPage::showMessage(const QString& sentence, const QString& owner)
{
    m_owner = owner;
    m_word->setText(sentence);
    m_goThere->setVisible(!owner.isEmpty());
}

void ShortcutsPage::goToOwner()
{
    const QString owner = m_owner;
    m_words->clear();
    m_list->setCurrentItem(m_list->itemOf(owner));
    m_list->setFocus();
}

QString ShortcutsPage::currentId() const
{
    const QAction* action = CommandList::actionOf(m_list->currentItem());
    return action ? action->objectName() : QString();
}

QString ShortcutsPage::nameOf(const QString& id) const
{
    return id.isEmpty() ? QString() : m_actions.get(id)->iconText();
}
} // namespace ui
