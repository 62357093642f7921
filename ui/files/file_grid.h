#pragma once

#include <QListView>

class QKeyEvent;

namespace ui
{
class FileItemDelegate;

/// A view of files as a grid of pictures. While it has the focus, the shortcuts of its own actions take precedence over
/// the window's.
class FileGrid : public QListView
{
    Q_OBJECT

public:
    explicit FileGrid(QWidget* parent = nullptr);

    /// Sets the delegate that paints the cells. It is not owned.
    void setCells(FileItemDelegate* delegate);
    /// Sets the width and height of the pictures, in logical pixels.
    void setPicture(int size);
    /// Returns the rows of which at least a part is visible.
    QModelIndexList visibleRows() const;
    QSize sizeHint() const override;

Q_SIGNALS:
    /// Other rows may be visible now.
    void moved();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void changeEvent(QEvent* event) override;

private:
    QAction* actionOf(const QKeyEvent& key) const;
    void layCells();

    FileItemDelegate* m_cells = nullptr;
};
} // namespace ui
