#pragma once

#include <QStyledItemDelegate>

namespace ui
{
class FileListModel;
class FileSorter;

/// A file in the grid: its picture, and under it name, vertices, size and date. The name is edited in its place.
class FileItemDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    FileItemDelegate(const FileListModel* files, const FileSorter* sorter, QObject* parent = nullptr);

    /// Of the picture, in logical pixels.
    void setPicture(int size) { m_picture = size; }
    QSize cell(const QFontMetrics& metrics) const;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// Filled once, when it is made: its picture may come while a name is typed.
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
