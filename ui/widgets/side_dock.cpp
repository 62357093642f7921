#include "ui/widgets/side_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace ui
{
namespace
{
/// Shows a panel whole where there is room, else scrolls it up and down.
class PanelScrollArea : public QScrollArea
{
public:
    explicit PanelScrollArea(QWidget* panel)
    {
        setSizePolicy(panel->sizePolicy());
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidgetResizable(true);
        setWidget(panel);
    }

    /// Returns the size in which nothing is scrolled: a panel whose rows may wrap can be higher than it wants to be.
    QSize sizeHint() const override
    {
        return widget()->sizeHint().expandedTo(widget()->minimumSizeHint()).expandedTo(minimumSizeHint());
    }
    /// Returns the panel's own width and that of the scroll bar, and the height of a few lines.
    QSize minimumSizeHint() const override
    {
        const QSize least = widget()->minimumSizeHint();
        return {least.width() + verticalScrollBar()->sizeHint().width(), std::min(least.height(), leastHeight())};
    }

protected:
    /// Takes the panel's new size when it gets other rows.
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QScrollArea::eventFilter(object, event);
    }

private:
    int leastHeight() const { return 4 * fontMetrics().lineSpacing(); }
};
} // namespace

void addSideDock(QMainWindow* window, QMenu* toggles, QDockWidget* dock, const QString& behind)
{
    QWidget* panel = dock->widget();
    dock->setWidget(nullptr);
    dock->setWidget(new PanelScrollArea(panel));
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
