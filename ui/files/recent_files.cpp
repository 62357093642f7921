#include "ui/files/recent_files.h"

#include "ui/files/file_jobs.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/settings/settings.h"
#include "ui/widgets/spacing.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QSize pictureSize{44, 44};

/// Returns a transparent picture, so that names are aligned before the pictures are made.
QIcon emptyPicture()
{
    QPixmap picture(pictureSize);
    picture.fill(Qt::transparent);
    return picture;
}
} // namespace

RecentFiles::RecentFiles(const Settings* settings, QWidget* parent) : QListWidget(parent), m_settings(settings)
{
    setIconSize(pictureSize);
    setSpacing(gap / 4);
    setTextElideMode(Qt::ElideMiddle);
    setVerticalScrollMode(ScrollPerPixel);
    const auto choose = [this](const QListWidgetItem* item) {
        if (const QString path = item->data(Qt::UserRole).toString(); !path.isEmpty())
            Q_EMIT chosen(path);
    };
    connect(this, &QListWidget::itemClicked, this, choose);
    connect(this, &QListWidget::itemActivated, this, choose); // Return or Enter
}

RecentFiles::~RecentFiles()
{
    m_disk.drop();
}

void RecentFiles::fill()
{
    clear();
    const QStringList paths = m_settings->recentFiles();
    if (paths.isEmpty())
        return take({});
    for (const QString& path : paths) {
        auto* item = new QListWidgetItem(emptyPicture(), QFileInfo(path).fileName(), this);
        item->setData(Qt::UserRole, path);
        item->setToolTip(QDir::toNativeSeparators(path));
    }
    const auto entries = [paths] {
        QList<FileEntry> there;
        for (const QString& path : paths)
            if (QFileInfo::exists(path))
                there << FileJobs::entryOf(path);
        return there;
    };
    m_disk.run(entries, [this, fill = ++m_fills](const QList<FileEntry>& there) {
        if (fill == m_fills)
            take(there);
    });
}

void RecentFiles::take(const QList<FileEntry>& there)
{
    for (int row = count() - 1; row >= 0; --row)
        if (const QString path = item(row)->data(Qt::UserRole).toString();
            std::ranges::find(there, path, &FileEntry::path) == there.end())
            delete takeItem(row);
    if (count() == 0) {
        auto* none = new QListWidgetItem(tr("None yet"), this);
        none->setFlags(Qt::NoItemFlags);
        return;
    }
    if (!m_maker) {
        m_maker = std::make_unique<ThumbnailMaker>();
        connect(m_maker.get(), &ThumbnailMaker::made, this, &RecentFiles::setPicture);
    }
    m_maker->request(there);
}

void RecentFiles::setPicture(const FileEntry& file, const Thumbnail& thumbnail)
{
    if (QListWidgetItem* item = itemOf(file.path); item && !thumbnail.picture.isNull())
        item->setIcon(QPixmap::fromImage(thumbnail.picture));
}

QListWidgetItem* RecentFiles::itemOf(const QString& path) const
{
    for (int row = 0; row < count(); ++row)
        if (item(row)->data(Qt::UserRole) == path)
            return item(row);
    return nullptr;
}
} // namespace ui
