#include "ui/actions/actions.h"

#include "ui/actions/key_position.h"
#include "ui/widgets/themed_icon.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QToolBar>

namespace ui
{
namespace
{
/// Starters have a picture of their model; all other icons are drawn in the text colour.
QIcon iconOf(const ActionInfo& row)
{
    const QString name = QLatin1StringView(row.icon);
    return row.menu == MenuId::New ? QIcon(QStringLiteral(":/pictures/%1.png").arg(name)) : themedIcon(name);
}

/// Returns two lines: the name with its key, such as "Pull (1)", and the tip.
QString toolTip(const QAction& action)
{
    QString name = action.iconText();
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    if (!key.isEmpty())
        name += QStringLiteral(" (%1)").arg(key);
    return QStringLiteral("%1\n%2").arg(name, action.statusTip());
}
} // namespace

Actions::Actions(QWidget* window) : QObject(window)
{
    for (const ActionInfo& row : actionTable())
        m_actions.insert(QLatin1StringView(row.id), make(row, window));
    setKeys({});
    window->installEventFilter(this);
}

QAction* Actions::make(const ActionInfo& row, QWidget* window)
{
    auto* action = new QAction(iconOf(row), tr(row.text), this);
    action->setObjectName(QLatin1StringView(row.id));
    action->setCheckable(row.checkable);
    action->setIconText(plain(action->text()));
    if (row.menu == MenuId::Files)
        action->setShortcutContext(Qt::WidgetShortcut);
    else
        window->addAction(action);
    return action;
}

QAction* Actions::get(const QString& id) const
{
    QAction* action = m_actions.value(id);
    Q_ASSERT_X(action, "Actions::get", qPrintable(id));
    return action;
}

void Actions::rename(const QString& id, const QString& text)
{
    QAction* action = get(id);
    action->setText(text);
    action->setIconText(plain(text));
    action->setToolTip(toolTip(*action));
}

/// Handles CJK texts too, where the mnemonic is a suffix in brackets: "拉出(&P)".
QString Actions::plain(QString text)
{
    static const QRegularExpression menuOnly(QStringLiteral("\\(&.\\)|&| ?…"));
    return text.remove(menuOnly);
}

void Actions::setKeys(const ShortcutSettings& shortcuts)
{
    m_shortcuts = shortcuts;
    m_keys = ShortcutMap(shortcuts);
    for (const ActionInfo& row : actionTable()) {
        QAction* action = get(QLatin1StringView(row.id));
        action->setShortcuts(m_keys.keys(action->objectName()));
        action->setStatusTip(
            tr(row.tip).replace(QLatin1StringView("%1"), modifierName(mouseModifiers(shortcuts.preset).invert)));
        action->setToolTip(toolTip(*action));
    }
}

QString Actions::modifierName(Qt::KeyboardModifier modifier)
{
    const QString withLetter = QKeySequence(modifier | Qt::Key_A).toString(QKeySequence::NativeText);
    return withLetter.section(u'+', 0, 0);
}

QString Actions::modifierHelp(ShortcutPreset preset)
{
    const MouseModifiers held = mouseModifiers(preset);
    const QString brush = tr("Hold %1 on the model to invert the tool, %2 to smooth.")
                              .arg(modifierName(held.invert), modifierName(Qt::ShiftModifier));
    return held.rightOrbits ? brush + u' ' + tr("The right button turns the view.") : brush;
}

namespace
{
/// Returns true if Home moves this widget to its first item, so that Home must not run a command.
bool hasHome(const QWidget* focus)
{
    return qobject_cast<const QComboBox*>(focus) || qobject_cast<const QAbstractItemView*>(focus) ||
           qobject_cast<const QAbstractSlider*>(focus) || qobject_cast<const QTabBar*>(focus);
}
} // namespace

/// Returns the command of a key press that Qt would not match. Three cases: on X11, Qt does not distinguish number-pad
/// shortcuts ("Num+1" would be "1"); French keyboards type digits only with Shift; other keyboards have no Latin
/// letters.
QString Actions::ownerOf(const QKeyEvent& event) const
{
    if (event.modifiers() & Qt::KeypadModifier)
        return m_keys.owner(event.keyCombination());
    const bool isPlain = !(event.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier));
    const Qt::Key key = keyByPosition(event);
    if (!isPlain || !key || !m_keys.owner(event.keyCombination()).isEmpty())
        return {};
    return m_keys.owner(QKeyCombination(event.modifiers(), key));
}

/// Runs the commands of keys that neither a widget nor Qt's shortcuts handle (see ownerOf()). Leaves Home to a focused
/// widget that uses it.
bool Actions::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (event->type() == QEvent::ShortcutOverride && key->key() == Qt::Key_Home &&
            hasHome(QApplication::focusWidget())) {
            event->accept();
            return true;
        }
        const QString id = ownerOf(*key);
        if (!id.isEmpty() && get(id)->shortcutContext() == Qt::WindowShortcut) {
            event->accept();
            if (event->type() == QEvent::KeyPress && !key->isAutoRepeat())
                get(id)->trigger();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

QString Actions::menuTitle(MenuId menu) const
{
    const QString titles[] = {
        tr("&File"),  tr("&New"),           tr("Files &Panel"), tr("&Edit"),       tr("&Sculpt"),
        tr("Tool&s"), tr("M&ask"),          tr("Mo&del"),       tr("Pa&rts"),      tr("&Area in the View"),
        tr("&View"),  tr("T&urn and Zoom"), tr("Mat&erial"),    tr("Ba&ckground"), tr("Refere&nce Image"),
        tr("V&R"),    tr("&Help")};
    static_assert(std::size(titles) == static_cast<std::size_t>(MenuId::Help) + 1);
    return titles[static_cast<std::size_t>(menu)];
}

void Actions::fill(QMenu* menu, MenuId which) const
{
    for (const ActionInfo& row : actionTable()) {
        if (row.menu != which)
            continue;
        if (row.startsGroup && !menu->isEmpty())
            menu->addSeparator();
        menu->addAction(get(QLatin1StringView(row.id)));
    }
}

QList<QList<QAction*>> Actions::groups(Bar which) const
{
    QList<QList<QAction*>> groups;
    for (const ActionInfo& row : actionTable()) {
        if (row.bar != which)
            continue;
        if (row.startsGroup || groups.isEmpty())
            groups.emplace_back();
        groups.back() << get(QLatin1StringView(row.id));
    }
    return groups;
}

void Actions::fill(QToolBar* bar, Bar which) const
{
    for (const QList<QAction*>& group : groups(which)) {
        if (!bar->actions().isEmpty())
            bar->addSeparator();
        bar->addActions(group);
    }
}
} // namespace ui
