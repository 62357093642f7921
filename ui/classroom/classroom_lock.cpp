#include "ui/classroom/classroom_lock.h"

#include "ui/actions/actions.h"
#include "ui/classroom/classroom.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/widgets/side_column.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QShortcut>
#include <QToolBar>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QLatin1StringView closedCommands[] = {
    QLatin1StringView("edit.preferences"), QLatin1StringView("edit.classroom"), QLatin1StringView("brush.fromModel"),
    QLatin1StringView("lesson.record"),    QLatin1StringView("model.insert"),   QLatin1StringView("model.printCheck")};
/// Panels that stay available in a class. A new panel is closed until it is added here, because it may lead to files.
constexpr QLatin1StringView openPanels[] = {QLatin1StringView("brushPanel"),     QLatin1StringView("topologyPanel"),
                                            QLatin1StringView("symmetryPanel"),  QLatin1StringView("colorPanel"),
                                            QLatin1StringView("turntablePanel"), QLatin1StringView("modelPanel"),
                                            QLatin1StringView("presetPanel")};

/// The lesson panel stays available too: LessonPanel::lock() removes its ways out.
constexpr QLatin1StringView lessonPanel("lessonPanel");

template <std::size_t count> bool isAmong(const QLatin1StringView (&names)[count], const QString& name)
{
    return std::ranges::find(names, name) != std::end(names);
}

/// Hides and disables an action. Hiding alone is not enough if other code enables the action again; disabling alone
/// leaves it visible.
void close(QAction* action)
{
    action->setVisible(false);
    action->setEnabled(false);
}

/// Closes all actions of the menu that are not allowed. Returns true if any action remains.
bool hideEmpty(const QMenu* menu, const QSet<QAction*>& allowed)
{
    bool hasSome = false;
    for (QAction* action : menu->actions()) {
        const bool stays = action->menu() ? hideEmpty(action->menu(), allowed) : allowed.contains(action);
        if (!stays && !action->isSeparator())
            close(action);
        hasSome = hasSome || stays;
    }
    return hasSome;
}

void hideEmptyMenus(const QMainWindow* window, const QSet<QAction*>& allowed)
{
    for (QAction* title : window->menuBar()->actions())
        if (title->menu() && !hideEmpty(title->menu(), allowed))
            close(title);
}

/// Shows a separator only if there are visible actions on both sides.
void hideLoneSeparators(const QToolBar* bar)
{
    QAction* line = nullptr;
    bool hasBefore = false;
    for (QAction* action : bar->actions()) {
        if (action->isSeparator()) {
            action->setVisible(false);
            line = hasBefore ? action : nullptr;
        } else if (action->isVisible()) {
            if (line)
                line->setVisible(true);
            line = nullptr;
            hasBefore = true;
        }
    }
}

bool isTool(const ActionInfo& row, const QList<core::Tool>& tools)
{
    return std::ranges::any_of(
        tools, [&row](core::Tool tool) { return std::string_view(row.id) == "tool." + std::string(core::name(tool)); });
}
} // namespace

bool isAllowed(const ActionInfo& row, const Classroom& classroom)
{
    switch (row.menu) {
    case MenuId::File:
        return std::string_view(row.id) == "file.quit";
    case MenuId::New:
    case MenuId::Files:
    case MenuId::Reference:
        return false;
    case MenuId::Help: // the other help actions lead to all commands or to lessons
        return std::string_view(row.id) == "help.guide";
    case MenuId::Tool:
        return isTool(row, classroom.tools);
    case MenuId::Mask:
        return classroom.tools.contains(core::Tool::Mask);
    case MenuId::Edit:
    case MenuId::Sculpt:
    case MenuId::Model:
    case MenuId::Parts:
    case MenuId::Area:
    case MenuId::View:
    case MenuId::Turn:
    case MenuId::Material:
    case MenuId::Background:
    case MenuId::Vr:
        return !isAmong(closedCommands, QLatin1StringView(row.id));
    }
    return false;
}

void lockWindow(QMainWindow* window, const Actions& actions, const Classroom& classroom)
{
    QSet<QAction*> allowed;
    for (const ActionInfo& row : actionTable()) {
        QAction* action = actions.get(QLatin1StringView(row.id));
        if (isAllowed(row, classroom))
            allowed << action;
        else
            close(action);
    }
    const auto* column = window->findChild<SideColumn*>();
    for (SidePanel* panel : column->panels()) {
        const bool isLesson = panel->objectName() == lessonPanel && !classroom.lesson.isEmpty();
        if (isLesson)
            panel->setState(SidePanel::State::Hidden);
        if (isLesson || isAmong(openPanels, panel->objectName())) {
            allowed << panel->toggleViewAction();
            continue;
        }
        panel->setState(SidePanel::State::Hidden);
        close(panel->toggleViewAction());
    }
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        if (dock == column)
            continue;
        dock->hide();
        close(dock->toggleViewAction());
    }
    auto* help = new QShortcut(Qt::Key_F1, window); // outside a class F1 lists all commands
    QObject::connect(help, &QShortcut::activated, actions.get(QStringLiteral("help.guide")), &QAction::trigger);
    window->findChild<LessonPanel*>()->lock();
    hideEmptyMenus(window, allowed);
    for (const QToolBar* bar : window->findChildren<QToolBar*>(Qt::FindDirectChildrenOnly))
        hideLoneSeparators(bar);
    window->setContextMenuPolicy(Qt::PreventContextMenu);
}

QHash<QString, bool> switchesOf(const Actions& actions)
{
    QHash<QString, bool> switches;
    for (const ActionInfo& row : actionTable())
        if (row.checkable && row.menu != MenuId::Vr)
            switches.insert(QLatin1StringView(row.id), actions.get(QLatin1StringView(row.id))->isChecked());
    return switches;
}

/// Restores the saved state of each action. In an exclusive group only the checked action is triggered; that unchecks
/// the others.
void setSwitches(const Actions& actions, const QHash<QString, bool>& switches)
{
    for (auto i = switches.begin(); i != switches.end(); ++i) {
        QAction* action = actions.get(i.key());
        const bool isOneOfSeveral = action->actionGroup() != nullptr;
        if (action->isEnabled() && action->isChecked() != i.value() && (i.value() || !isOneOfSeveral))
            action->trigger();
    }
}
} // namespace ui
