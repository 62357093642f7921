#include "ui/widgets/side_dock.h"

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
} // namespace ui
