#include "ui/files/file_grid.h"

#include "ui/files/file_item_delegate.h"

#include <QAction>
#include <QKeyEvent>
#include <QScrollBar>

namespace ui
{
FileGrid::FileGrid(QWidget* parent) : QListView(parent)
{
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // A scroll bar that appears and disappears would change the number of columns
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setUniformItemSizes(true);
    setContextMenuPolicy(Qt::CustomContextMenu);
}

void FileGrid::setCells(FileItemDelegate* delegate)
{
    m_cells = delegate;
    setItemDelegate(delegate);
    layCells();
}

void FileGrid::setPicture(int size)
{
    m_cells->setPicture(size);
    layCells();
    Q_EMIT moved();
}

/// Returns the size of two columns and two rows.
QSize FileGrid::sizeHint() const
{
    const QSize cell = m_cells->cell(fontMetrics());
    return {2 * cell.width() + verticalScrollBar()->sizeHint().width() + 2 * frameWidth() + 2, 2 * cell.height()};
}

/// Divides the width evenly among the columns.
void FileGrid::layCells()
{
    if (!m_cells)
        return;
    const QSize cell = m_cells->cell(fontMetrics());
    const int available = viewport()->width() - 1, columns = qMax(1, available / cell.width());
    setGridSize({qMax(cell.width(), available / columns), cell.height()});
    verticalScrollBar()->setSingleStep(cell.height() / 3);
}

QModelIndexList FileGrid::visibleRows() const
{
    QModelIndexList rows;
    for (int row = 0; model() && row < model()->rowCount(); ++row)
        if (const QModelIndex index = model()->index(row, 0); visualRect(index).intersects(viewport()->rect()))
            rows << index;
    return rows;
}

QAction* FileGrid::actionOf(const QKeyEvent& key) const
{
    if (state() == EditingState)
        return nullptr;
    const QKeySequence pressed(key.keyCombination());
    for (QAction* action : actions())
        if (action->isEnabled() && action->shortcuts().contains(pressed))
            return action;
    return nullptr;
}

bool FileGrid::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && actionOf(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QListView::event(event);
}

void FileGrid::keyPressEvent(QKeyEvent* event)
{
    if (QAction* action = actionOf(*event))
        action->trigger();
    else
        QListView::keyPressEvent(event);
}

void FileGrid::resizeEvent(QResizeEvent* event)
{
    QListView::resizeEvent(event);
    layCells();
    Q_EMIT moved();
}

void FileGrid::scrollContentsBy(int dx, int dy)
{
    QListView::scrollContentsBy(dx, dy);
    Q_EMIT moved();
}

void FileGrid::changeEvent(QEvent* event)
{
    QListView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        layCells();
}
} // namespace ui
