#pragma once

#include <QStyledItemDelegate>

namespace ui
{
class FileListModel;
class FileSorter;

/// Paints a cell of the grid: the picture, and below it name, vertices, size and date. The name can be edited in place.
class FileItemDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    FileItemDelegate(const FileListModel* files, const FileSorter* sorter, QObject* parent = nullptr);

    /// Sets the width and height of the picture, in logical pixels.
    void setPicture(int size) { m_picture = size; }
    QSize cell(const QFontMetrics& metrics) const;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// Does nothing: createEditor() sets the text once, and a picture that arrives while the user types must not reset
    /// it.
    void setEditorData(QWidget*, const QModelIndex&) const override {}
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

private:
    QRect nameRect(const QStyleOptionViewItem& option) const;
    void paintPicture(QPainter* painter, const QRect& area, const QModelIndex& file) const;

    const FileListModel* m_files;
    const FileSorter* m_sorter;
    int m_picture;
};
} // namespace ui
