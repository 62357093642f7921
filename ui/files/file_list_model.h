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
/// The folders and models of one folder, with what is known of each. Of the pictures it keeps as many as some 64 MB
/// hold. Thread: gui.
class FileListModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role { VerticesRole = Qt::UserRole, ProblemRole };

    explicit FileListModel(QObject* parent = nullptr);

    void clear();
    /// Rows that stay keep their place and what is known of them.
    void setEntries(const QList<FileEntry>& entries);
    void setThumbnail(const FileEntry& file, const Thumbnail& thumbnail);

    const FileEntry& entry(const QModelIndex& index) const { return m_rows[index.row()].entry; }
    QModelIndex indexOf(const QString& path) const;
    /// Nothing is known of the file yet; or it has a picture that is not at hand.
    bool isUnknown(const QModelIndex& index) const;
    bool lacksPicture(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// A name without ending, which is asked for by renameRequested().
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    /// Three lines: name; vertices, or what is wrong; size and date.
    QString name(const QModelIndex& index) const;
    QString measure(const QModelIndex& index) const;
    QString stamp(const QModelIndex& index) const;
    /// About as long as a third line can be.
    static QString longStamp();

Q_SIGNALS:
    void renameRequested(const QString& path, const QString& name);
    /// A picture that is in sight is not at hand any more.
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
    QCache<QString, QPixmap> m_pictures; ///< by path, in bytes
};

/// The same in order: folders first, what is not known last, names as people count.
class FileSorter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit FileSorter(FileListModel* files);

    void order(FileOrder by, bool descending);
    /// Names that hold these letters, in either case.
    void filter(const QString& part);

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    FileListModel* m_files;
    QCollator m_collator;
    FileOrder m_by = FileOrder::Name;
};
} // namespace ui
