#pragma once

#include "ui/files/file_entry.h"
#include "ui/files/thumbnail_cache.h"
#include "ui/settings/file_browser_settings.h"

#include <QAbstractListModel>
#include <QCache>
#include <QCollator>
#include <QPixmap>
#include <QSortFilterProxyModel>

namespace ui
{
/// The folders and models of a folder, with vertex counts and pictures. Pictures are cached up to 64 MB. Thread: gui.
class FileListModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role { VerticesRole = Qt::UserRole, ProblemRole };

    explicit FileListModel(QObject* parent = nullptr);

    void clear();
    /// Replaces the entries. Unchanged files keep their row, vertex count and picture.
    void setEntries(const QList<FileEntry>& entries);
    void setThumbnail(const FileEntry& file, const Thumbnail& thumbnail);

    const FileEntry& entry(const QModelIndex& index) const { return m_rows[index.row()].entry; }
    QModelIndex indexOf(const QString& path) const;
    /// Returns true if the file has not been read yet. lacksPicture(): the picture is not in the cache, and no problem
    /// is known.
    bool isUnknown(const QModelIndex& index) const;
    bool lacksPicture(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// Emits renameRequested() with the new name, without the suffix.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    /// Return the three lines of a cell: name; number of vertices or the problem; size and date.
    QString name(const QModelIndex& index) const;
    QString measure(const QModelIndex& index) const;
    QString stamp(const QModelIndex& index) const;
    /// Returns a third line of about the greatest length, for the width of cells.
    static QString longStamp();

Q_SIGNALS:
    void renameRequested(const QString& path, const QString& name);
    /// A visible picture is no longer in the cache.
    void pictureMissed() const;

private:
    struct Row
    {
        FileEntry entry;
        qint64 vertices = -1;
        QString problem;

        bool isKnown() const { return entry.isFolder || vertices >= 0 || !problem.isEmpty(); }
    };

    QString description(const QModelIndex& index) const;
    QVariant picture(const Row& row) const;

    QList<Row> m_rows;
    QCache<QString, QPixmap> m_pictures; ///< pictures by file path; cost in bytes
};

/// Sorts and filters a FileListModel: folders first, numbers in names by value. Sorted by vertices, files whose number
/// of vertices is unknown are last.
class FileSorter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit FileSorter(FileListModel* files);

    void order(FileOrder by, bool descending);
    /// Shows only names that contain `part`, ignoring case.
    void filter(const QString& part);

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    FileListModel* m_files;
    QCollator m_collator;
    FileOrder m_by = FileOrder::Name;
};
} // namespace ui
