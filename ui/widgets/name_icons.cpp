#include "ui/widgets/name_icons.h"

#include <QFileInfo>
#include <QMimeDatabase>

namespace ui
{
QIcon NameIcons::icon(const QFileInfo& file) const
{
    return QFileIconProvider::icon(file.isDir() ? Folder : File);
}

QString NameIcons::type(const QFileInfo& file) const
{
    const QMimeDatabase kinds;
    return (file.isDir() ? kinds.mimeTypeForName(QStringLiteral("inode/directory"))
                         : kinds.mimeTypeForFile(file.fileName(), QMimeDatabase::MatchExtension))
        .comment();
}
} // namespace ui
