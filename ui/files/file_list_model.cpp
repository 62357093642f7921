#include "ui/files/file_list_model.h"

#include "ui/util/path_display.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace ui
{
namespace
{
constexpr qsizetype pictureBytes = 64 << 20;

/// Returns the name by string operations only, because sorting calls it for each comparison.
QString fileName(const FileEntry& entry)
{
    return entry.path.mid(entry.path.lastIndexOf(QLatin1Char('/')) + 1);
}

QString sizeOf(qint64 bytes)
{
    constexpr qint64 mega = 1 << 20;
    return QLocale().formattedDataSize(bytes, bytes < mega ? 0 : 1, QLocale::DataSizeTraditionalFormat);
}

QDateTime dateOf(const FileEntry& entry)
{
    return QDateTime::fromMSecsSinceEpoch(entry.modifiedMs);
}
} // namespace

FileListModel::FileListModel(QObject* parent) : QAbstractListModel(parent), m_pictures(pictureBytes) {}

void FileListModel::clear()
{
    beginResetModel();
    m_rows.clear();
    m_pictures.clear();
    endResetModel();
}

void FileListModel::setEntries(const QList<FileEntry>& entries)
{
    QHash<QString, const FileEntry*> added;
    for (const FileEntry& entry : entries)
        added.insert(entry.path, &entry);
    for (int row = static_cast<int>(m_rows.size()) - 1; row >= 0; --row) {
        const FileEntry* entry = added.take(m_rows[row].entry.path);
        if (entry && *entry == m_rows[row].entry)
            continue;
        if (entry) { // the old picture stays until a new one is set
            m_rows[row] = {*entry, -1, {}};
            Q_EMIT dataChanged(index(row), index(row));
            continue;
        }
        m_pictures.remove(m_rows[row].entry.path);
        beginRemoveRows({}, row, row);
        m_rows.removeAt(row);
        endRemoveRows();
    }
    if (added.isEmpty())
        return;
    beginInsertRows({}, static_cast<int>(m_rows.size()), static_cast<int>(m_rows.size() + added.size()) - 1);
    for (const FileEntry& entry : entries)
        if (added.remove(entry.path))
            m_rows << Row{entry, -1, {}};
    endInsertRows();
}

void FileListModel::setThumbnail(const FileEntry& file, const Thumbnail& thumbnail)
{
    const QModelIndex index = indexOf(file.path);
    if (!index.isValid() || entry(index) != file) // the file has changed since the request
        return;
    m_rows[index.row()].vertices = thumbnail.vertices;
    m_rows[index.row()].problem = thumbnail.problem;
    m_pictures.remove(file.path);
    if (!thumbnail.picture.isNull())
        m_pictures.insert(file.path, new QPixmap(QPixmap::fromImage(thumbnail.picture)),
                          thumbnail.picture.sizeInBytes());
    Q_EMIT dataChanged(index, index);
}

QModelIndex FileListModel::indexOf(const QString& path) const
{
    const auto found = std::ranges::find_if(m_rows, [&](const Row& row) { return row.entry.path == path; });
    return found == m_rows.end() ? QModelIndex() : index(static_cast<int>(found - m_rows.begin()));
}

bool FileListModel::isUnknown(const QModelIndex& index) const
{
    return !m_rows[index.row()].isKnown();
}

bool FileListModel::lacksPicture(const QModelIndex& index) const
{
    const Row& row = m_rows[index.row()];
    return !row.entry.isFolder && row.problem.isEmpty() && !m_pictures.contains(row.entry.path);
}

int FileListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

Qt::ItemFlags FileListModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const auto all = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return entry(index).isFolder ? all : all | Qt::ItemIsEditable;
}

QVariant FileListModel::data(const QModelIndex& index, int role) const
{
    const Row& row = m_rows[index.row()];
    switch (role) {
    case Qt::DisplayRole:
        return name(index);
    case Qt::EditRole:
        return QFileInfo(row.entry.path).completeBaseName();
    case Qt::DecorationRole:
        return picture(row);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return description(index);
    case VerticesRole:
        return row.vertices;
    case ProblemRole:
        return row.problem;
    default:
        return {};
    }
}

QVariant FileListModel::picture(const Row& row) const
{
    if (const QPixmap* picture = m_pictures.object(row.entry.path))
        return *picture;
    if (row.vertices >= 0)
        Q_EMIT pictureMissed();
    return {};
}

bool FileListModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || value.toString() == data(index, role).toString())
        return false;
    Q_EMIT renameRequested(entry(index).path, value.toString());
    return true;
}

QString FileListModel::name(const QModelIndex& index) const
{
    return fileName(entry(index));
}

QString FileListModel::measure(const QModelIndex& index) const
{
    const Row& row = m_rows[index.row()];
    if (row.entry.isFolder)
        return tr("folder");
    if (!row.problem.isEmpty())
        return tr("cannot be read");
    return row.vertices < 0 ? tr("not read yet") : tr("%Ln vertices", nullptr, static_cast<int>(row.vertices));
}

QString FileListModel::stamp(const QModelIndex& index) const
{
    const FileEntry& file = entry(index);
    const QString date = QLocale().toString(dateOf(file).date(), QLocale::ShortFormat);
    return file.isFolder ? date : tr("%1, %2", "size, date").arg(sizeOf(file.size), date);
}

QString FileListModel::longStamp()
{
    constexpr qint64 bytes = 888;
    return tr("%1, %2", "size, date").arg(sizeOf(bytes), QLocale().toString(QDate(2028, 12, 28), QLocale::ShortFormat));
}

QString FileListModel::description(const QModelIndex& index) const
{
    const Row& row = m_rows[index.row()];
    if (!row.problem.isEmpty())
        return row.problem;
    QStringList lines{QDir::toNativeSeparators(row.entry.path), measure(index)};
    if (!row.entry.isFolder)
        lines << sizeOf(row.entry.size);
    lines << QLocale().toString(dateOf(row.entry), QLocale::ShortFormat);
    return lines.join(QLatin1Char('\n'));
}

FileSorter::FileSorter(FileListModel* files) : QSortFilterProxyModel(files), m_files(files), m_collator(nameCollator())
{
    setFilterCaseSensitivity(Qt::CaseInsensitive);
    setSourceModel(files);
    sort(0);
}

void FileSorter::order(FileOrder by, bool descending)
{
    m_by = by;
    invalidate();
    sort(0, descending ? Qt::DescendingOrder : Qt::AscendingOrder);
}

void FileSorter::filter(const QString& part)
{
    setFilterFixedString(part.trimmed());
}

bool FileSorter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const FileEntry &a = m_files->entry(left), &b = m_files->entry(right);
    const bool isUp = sortOrder() == Qt::AscendingOrder;
    if (a.isFolder != b.isFolder)
        return a.isFolder == isUp;
    const int byName = m_collator.compare(fileName(a), fileName(b));
    const auto less = [&](qint64 x, qint64 y) { return x != y ? x < y : byName < 0; };
    switch (a.isFolder && m_by != FileOrder::Date ? FileOrder::Name : m_by) {
    case FileOrder::Name:
        break;
    case FileOrder::Size:
        return less(a.size, b.size);
    case FileOrder::Date:
        return less(a.modifiedMs, b.modifiedMs);
    case FileOrder::Vertices: {
        const qint64 x = left.data(FileListModel::VerticesRole).toLongLong(),
                     y = right.data(FileListModel::VerticesRole).toLongLong();
        return (x < 0) != (y < 0) ? (y < 0) == isUp : less(x, y);
    }
    }
    return byName < 0;
}
} // namespace ui
