#include "ui/widgets/side_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

namespace ui
{
void addSideDock(QMainWindow* window, QMenu* toggles, QDockWidget* dock, const QString& behind)
{
    window->addDockWidget(Qt::RightDockWidgetArea, dock);
    toggles->addAction(dock->toggleViewAction());
    if (auto* first = behind.isEmpty() ? nullptr : window->findChild<QDockWidget*>(behind)) {
        window->tabifyDockWidget(first, dock);
        first->raise();
    }
}

QDockWidget* addSideDock(QMainWindow* window, QMenu* toggles, const QString& name, const QString& title,
                         QWidget* content)
{
    auto* dock = new QDockWidget(title);
    dock->setObjectName(name);
    dock->setWidget(content);
    addSideDock(window, toggles, dock, QStringLiteral("brushPanel"));
    return dock;
}

void showBy(const QAction* action, QDockWidget* dock)
{
    dock->hide();
    QObject::connect(action, &QAction::triggered, dock, [dock] {
        dock->show();
        dock->raise();
    });
}
} // namespace ui
